#pragma once
// The step and the time of the run.
#include <cstdint>

namespace vug {

inline constexpr double most_steps = 1e15;  ///< largest number of lattice steps of a run, as for time.steps

/// Lattice steps done and their length; a module that takes fewer steps uses `every`.
struct Clock {
  std::int64_t step = 0;  ///< completed lattice steps
  double time_step = 0;   ///< s
  double ahead = 0;  ///< s by which the rock has aged beyond the steps of the fluid (accuracy.dissolution_tolerance)

  double time() const { return static_cast<double>(step) * time_step + ahead; }  ///< s, age of the rock
  /// Whether an action that is due every `interval` steps is taken after the step that follows.
  bool every(std::int64_t interval) const { return interval > 0 && (step + 1) % interval == 0; }
};

}  // namespace vug
