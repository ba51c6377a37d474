#pragma once
// The loads of a case on the sides of the rock, in the form that its mechanics takes.
#include "dem/loads.hpp"
#include "io/scene.hpp"

namespace vug {

constexpr RockSide rock_side(Side side) {
  return static_cast<RockSide>(static_cast<int>(side) - 1);
}
static_assert(rock_side(Side::right) == RockSide::right && rock_side(Side::top) == RockSide::top &&
              rock_side(Side::left) == RockSide::left && rock_side(Side::bottom) == RockSide::bottom);

/// Stresses and supports of the four sides and their parts, and gravity. A side whose loads change in time, or whose
/// platen moves, is stored as a part as long as the side.
Loads boundary_loads(const Scene& scene);

/// Stresses on the rock, Pa; 0: unknown.
struct LargestLoad {
  double ever = 0;    ///< the largest at any time
  double change = 0;  ///< the largest change of one after the preload, or that of the least traction that changes
};

/// The largest stress on the rock that is known from the case. It is the largest of: tractions; deviations of given
/// pressures from the initial one; prevented thermal expansion M_n alpha dT; weight of the rock, and body force on the
/// fluid, over the longest side; the waves of initial velocities. Of these, the preload applies the weight and the
/// tractions at the start. Where rock dissolves, all that it bore changes over to its neighbours. The pressure that a
/// given flow needs is unknown.
LargestLoad largest_load(const Scene& scene);

}  // namespace vug
