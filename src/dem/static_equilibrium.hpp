#pragma once
// Where loaded rock rests, from its stiffness and not by waiting until its waves have died away.
#include "dem/contacts.hpp"
#include "dem/loads.hpp"
#include "dem/neighbour_grid.hpp"

namespace vug {

/// Moves all particles to where boundary loads, gravity, outside forces, bonds and contacts balance: u, angle and
/// rotation of `particles`, velocities zero; whether it has found the place. Springs of the rock beyond take no part,
/// as in a preload.
///
/// Newton's method: the imbalance comes from the kernels of a step, the matrix from the bonds (closed cracks resist
/// compression, sticking ones shear), factored by Eigen's sparse Cholesky (LDL^T). Cracks may slide, so that the loads
/// rise in increments where there are any, and friction follows as it would in a slow ramp.
///
/// Not found where sides do not hold the rock, where something breaks on the way, or where contacts beside the bonds
/// carry load, also such as only the last increment brings about; what the state is then is not said: the caller
/// restores it. Works on the host, for set-up.
bool find_static_equilibrium(const Exec& exec, const MechanicsParameters& parameters, const NeighbourGrid& grid,
                             const BoundaryLoads& loads, const Particles& particles, const Bonds& bonds,
                             const Contacts& contacts);

}  // namespace vug
