#pragma once
// How fast body forces can drive fluid through pores.
#include "coupling/body_forces.hpp"
#include "coupling/mouths.hpp"

#include <vector>

namespace vug {

struct ForceSpeed {
  double ever = 0;        ///< the same for any duration, so that a run may be given a later end
  double by_the_end = 0;  ///< of the run
};

/// Upper bounds, lattice units, of the speed that the body forces of a case (body_forces.hpp) drive along an axis on
/// which the fluid has a way: across joined sides, or between two open ones. 0 without a way. It is the least of
///   - g w^2/(8 nu), with w the width of the widest pore (the shorter of a node's runs of fluid along x and y);
///   - the speed at which a Stokes flow through one line of nodes after the other loses all of g along the lattice;
///   - between open sides (2 g L)^1/2;
///   - by the end of the run, g times its duration.
/// nu is the lowest viscosity, and g the largest acceleration, of the temperatures of the case. Between sides with
/// given pressures, g is the sum of the body forces and their gradient: 0 for a fluid at rest under its weight. `width`
/// and `piece` are those of each node (shorter_widths, pieces_of).
ForceSpeed body_force_speed(const Scene& scene, const BodyForces& forces, const FluidPicture& picture,
                            const std::vector<double>& width, const std::vector<Mouth>& mouths,
                            const std::vector<int>& piece, const LatticeUnits& units);

}  // namespace vug
