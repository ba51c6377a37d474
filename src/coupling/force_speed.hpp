#pragma once
// How fast a body force can drive fluid through pores.
#include "coupling/mouths.hpp"

#include <vector>

namespace vug {

/// Upper bound, lattice units, of the speed that flow.body_force drives along an axis on which the fluid has a way:
/// across joined sides, or between two open ones. 0 without a way. It is the least of
///   - g w^2/(8 nu), with w the width of the widest pore (the shorter of a node's runs of fluid along x and y);
///   - the speed at which a Stokes flow through one line of nodes after the other loses all of g along the lattice;
///   - g times the duration, and between open sides (2 g L)^1/2.
/// nu is the lowest viscosity of the temperatures of the case. Between sides with given pressures, g is the sum of the
/// body force and their gradient: 0 for a fluid at rest under its weight.
/// `piece` is that of each node.
double body_force_speed(const Scene& scene, const FluidPicture& picture, const std::vector<Mouth>& mouths,
                        const std::vector<int>& piece, const LatticeUnits& units);

}  // namespace vug
