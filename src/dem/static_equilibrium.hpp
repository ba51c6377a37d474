#pragma once
// Static equilibrium of loaded rock, from its stiffness instead of waiting until its waves have died away.
#include "dem/contacts.hpp"
#include "dem/loads.hpp"
#include "dem/neighbour_grid.hpp"
#include "ranks/ranks.hpp"

namespace vug {

/// Moves all particles to where boundary loads, gravity, outside forces, bonds and contacts balance: sets u, angle and
/// rotation of `particles`, and velocities to zero. Returns whether it has found this state. Springs of the rock beyond
/// do not act, as in a preload.
///
/// Newton's method: the imbalance comes from the kernels of a step, the matrix from the bonds (closed cracks resist
/// compression, those that stick also shear), factorised by Eigen's sparse Cholesky (LDL^T). Where there are cracks,
/// which may slide, the loads rise in increments, so that friction develops as in a slow ramp.
///
/// The state is not found where sides do not hold the rock, where something breaks on the way, or where contacts beside
/// the bonds carry load, also contacts that appear only in the last increment. It is then undefined, and the caller
/// must restore it. Works on the host, for set-up; all `ranks` do the same, and stop together.
bool find_static_equilibrium(const Exec& exec, const MechanicsParameters& parameters, const NeighbourGrid& grid,
                             const BoundaryLoads& loads, const Particles& particles, const Bonds& bonds,
                             const Contacts& contacts, const Ranks& ranks);

}  // namespace vug
