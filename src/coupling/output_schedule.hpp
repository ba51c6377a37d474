#pragma once
// When snapshots, rows of the history and checkpoints are due.
#include "coupling/clock.hpp"
#include "io/scene.hpp"

#include <cmath>

namespace vug {

/// Due after the lattice step nearest to each multiple of `steps`, which need not be a whole number. With `seconds` >
/// 0: due whenever the time passes a multiple of `seconds` instead.
class Schedule {
 public:
  Schedule(double steps, double seconds) : steps_(steps), seconds_(seconds) {}

  /// Whether it is due after the step from `before` to `now`.
  bool due(const Clock& before, const Clock& now) const {
    if (seconds_ == 0) return now.step == std::llround(std::round(static_cast<double>(now.step) / steps_) * steps_);
    return std::floor(now.time() / seconds_ + rounding) > std::floor(before.time() / seconds_ + rounding);
  }

 private:
  static constexpr double rounding = 1e-9;
  double steps_;  ///< at least 1
  double seconds_;
};

/// Number of lattice steps of the case.
std::int64_t last_step(const Scene& scene);

/// Lattice steps between two snapshots and between two rows of the history, not necessarily whole numbers; those that
/// the case does not give are the defaults: one snapshot at the end, about 400 rows.
double output_interval(const Scene& scene);
double history_interval(const Scene& scene);

/// Time between two rows of the history, s.
double row_interval(const Scene& scene);

/// Schedules of snapshots, rows of the history and checkpoints.
Schedule output_schedule(const Scene& scene);
Schedule row_schedule(const Scene& scene);
Schedule checkpoint_schedule(const Scene& scene);

}  // namespace vug
