#pragma once
// When something is due again.
#include "coupling/clock.hpp"
#include "io/scene.hpp"

#include <cmath>

namespace vug {

/// Every so many lattice steps, which need not be a whole number: after the step nearest to each multiple. Or, with
/// seconds, whenever the time passes a multiple of these.
class Schedule {
 public:
  Schedule(double steps, double seconds) : steps_(steps), seconds_(seconds) {}

  /// Whether it is after the step from `before` to `now`.
  bool due(const Clock& before, const Clock& now) const {
    if (seconds_ == 0) return now.step == std::llround(std::round(static_cast<double>(now.step) / steps_) * steps_);
    return std::floor(now.time() / seconds_ + rounding) > std::floor(before.time() / seconds_ + rounding);
  }

 private:
  static constexpr double rounding = 1e-9;
  double steps_;  ///< at least 1
  double seconds_;
};

/// Lattice steps that the case asks for.
std::int64_t last_step(const Scene& scene);

/// When snapshots, rows of the history and checkpoints are due.
Schedule output_schedule(const Scene& scene);
Schedule row_schedule(const Scene& scene);
Schedule checkpoint_schedule(const Scene& scene);

}  // namespace vug
