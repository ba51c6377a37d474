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

/// The largest stress (Pa) on the rock at any time that is known from the case. It is the largest of: tractions;
/// deviations of given pressures from the initial one; prevented thermal expansion M_n alpha dT; weight of the rock,
/// and body force on the fluid, over the longest side; the waves of initial velocities. 0 where the case has none of
/// these. The pressure that a given flow needs is unknown.
double largest_load(const Scene& scene);

}  // namespace vug
