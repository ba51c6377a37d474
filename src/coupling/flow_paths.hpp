#pragma once
// Where the fluid can flow from the sides of the lattice and from openings, and what the conditions there mean in this
// geometry: found once, before the first step.
#include "coupling/geometry.hpp"
#include "coupling/pressed_speed.hpp"
#include "io/units.hpp"

#include <string>
#include <vector>

namespace vug {

/// Speed, lattice units, above which results of the weakly compressible scheme have no meaning.
inline constexpr double speed_bound = 0.5;
/// Largest deviation of the density from 1 that is accepted as a flow, lattice units.
inline constexpr double density_bound = 2;

/// What was found in the geometry.
struct FlowPaths {
  /// Largest mean speed, lattice units, in the narrowest passage behind a prescribed velocity: the volume that enters
  /// per step over the smallest number of nodes at one distance from the inlet, up to an outlet.
  double passage_speed = 0;
  /// Pressure, lattice units, that prescribed velocities need to overcome the drag up to an outlet: the sum of 12 nu
  /// q/n^3 over the distances from the inlet, with n nodes at each; a lower bound.
  double passage_pressure = 0;
  /// Largest speed, lattice units, that prescribed velocities may cause on their way to an outlet (passages.hpp).
  double passage_peak = 0;
  /// Upper bounds of the speed that body forces drive, lattice units: in the duration of the run, and in any
  /// (force_speed.hpp).
  double force_speed = 0, lasting_force_speed = 0;
  double weight_speed = 0;  ///< upper bound of the speed while the weight of the fluid sets in (weight_wave.hpp)
  /// Lattice steps in which the deviation from the steady flow falls to 1/e; a lower bound as well. For a channel of L
  /// x n cells: 36 nu L^2/(pi n)^2 between two pressures, four times that between a velocity and a pressure.
  double settling_steps = 0;
  PressedFlow pressed{};              ///< the fastest flow that pressures drive against viscosity (pressed_speed.hpp)
  std::vector<std::string> warnings;  ///< one line each: allowed, but probably not meant
};

/// Follows the fluid from every stretch that lets fluid through. Throws InputError for what can only be a mistake: no
/// fluid at all, a velocity above speed_bound, an injection or a shape that touches no fluid, fluid that is pressed
/// into a space without an outlet. The last two are warnings where rock may open later.
FlowPaths find_flow_paths(const Scene& scene, const Geometry& geometry, const LatticeUnits& units);

}  // namespace vug
