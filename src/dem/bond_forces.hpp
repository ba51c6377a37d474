#pragma once
// Forces of all bonds, intact or failed, each into its own slot.
#include "dem/accounts.hpp"
#include "dem/bonds.hpp"
#include "kernels/launch_in_turn.hpp"

namespace vug {

/// Evaluates every bond at the current displacements and velocities: advances its damage, its state and the slider of
/// its crack, and writes Bonds::load and Bonds::stress. dt is the step over which losses are accounted.
/// `awake` names the groups of bonds that are evaluated; null: all.
template <class Keeper>
void compute_bond_forces(const Exec& exec, const MechanicsParameters& parameters, double dt, const Particles& particles,
                         const Bonds& bonds, const Keeper& accounts, const Groups* awake = nullptr);

}  // namespace vug
