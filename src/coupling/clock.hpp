#pragma once
// Where the run stands.
#include <cstdint>

namespace vug {

inline constexpr double most_steps = 1e15;  ///< lattice steps of a run, as for time.steps

/// Lattice steps done and their length; a module that steps less often asks `every`.
struct Clock {
  std::int64_t step = 0;  ///< completed lattice steps
  double time_step = 0;   ///< s
  double ahead = 0;  ///< s by which the rock has aged more than the fluid has stepped (accuracy.dissolution_tolerance)

  double time() const { return static_cast<double>(step) * time_step + ahead; }  ///< s, of the rock
  /// True in the steps after which an action due every `interval` steps is taken.
  bool every(std::int64_t interval) const { return interval > 0 && (step + 1) % interval == 0; }
};

}  // namespace vug
