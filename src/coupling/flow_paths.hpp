#pragma once
// Where the fluid can go from the sides of the lattice and from openings, and what the geometry makes of the conditions
// there: looked at once, before the first step.
#include "coupling/geometry.hpp"
#include "kernels/base/units.hpp"

#include <string>
#include <vector>

namespace vug {

/// Beyond this speed, lattice units, the weakly compressible scheme has lost its meaning whatever it still computes.
inline constexpr double speed_bound = 0.5;
/// Largest deviation of the density from 1 that passes as a flow, lattice units.
inline constexpr double density_bound = 2;

/// What is found in the geometry at the start.
struct FlowPaths {
  /// Largest mean speed, lattice units, that the prescribed velocities drive through a narrowest passage: the volume
  /// that a piece of fluid takes in over the least number of nodes at one distance from where it does, before an
  /// outlet.
  double passage_speed = 0;
  /// Pressure, lattice units, that prescribed velocities need to overcome the drag on the way to an outlet, sum of
  /// 12 nu q/n^3 over distances at which n nodes are crossed; never too much.
  double passage_pressure = 0;
  /// Lattice steps in which what the flow lacks of its steady state falls to 1/e, likewise: of a channel of L x n cells
  /// 36 nu L^2/(pi n)^2 between two pressures, four times that between a velocity and a pressure.
  double settling_steps = 0;
  std::vector<std::string> warnings;  ///< one line each: allowed, but probably not meant
};

/// Follows the fluid from every stretch that lets some through. Throws InputError for what can only be a mistake: no
/// fluid at all, a velocity above speed_bound, an injection or a shape that touches no fluid, fluid that is pressed
/// into a piece without an outlet; the last two are warnings where rock may open later.
FlowPaths find_flow_paths(const Scene& scene, const Geometry& geometry, const LatticeUnits& units);

}  // namespace vug
