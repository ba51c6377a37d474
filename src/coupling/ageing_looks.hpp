#pragma once
// How often it is looked at how much faster the rock may age than the fluid.
#include "io/scene.hpp"

#include <algorithm>
#include <numeric>

namespace vug {

/// Lattice steps between looks: at least ten steps of the solutes, and such that the walls are booked at each look: a
/// common multiple of the intervals of updates and solutes.
inline int look_interval(const AccuracySection& accuracy) {
  constexpr int solute_steps = 10;
  const int both = std::lcm(accuracy.update_interval, accuracy.solute_interval);
  return both * std::max(1, (solute_steps * accuracy.solute_interval + both - 1) / both);
}

}  // namespace vug
