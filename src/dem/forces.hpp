#pragma once
// Forces of bonds, intact or failed, and of triangles that touch without being bonded, each stored in its own slot.
#include "dem/accounts.hpp"
#include "dem/contacts.hpp"
#include "dem/launch_in_turn.hpp"

namespace vug {

/// Groups of bonds to evaluate, and groups of particles whose pairs (as their lower particles) are evaluated; null:
/// all. Pairs only together with bonds.
struct ForceGroups {
  const Groups* bonds = nullptr;
  const Groups* pairs = nullptr;
};

/// Evaluates every bond and every candidate pair at the current displacements and velocities, in one launch. For bonds
/// it updates damage, state and the slider of their crack, and writes Bonds::load and Bonds::stress. For pairs it
/// advances the friction springs by dt and writes Contacts::load, which the integrator gathers into Contacts::push. dt
/// is also the step over which losses are accounted. `only` selects what is evaluated.
template <class Keeper>
void compute_forces(const Queue& queue, const MechanicsParameters& parameters, double dt, const Particles& particles,
                    const Bonds& bonds, const Contacts& contacts, const Keeper& accounts, const ForceGroups& only = {});

/// The same for the pairs alone.
template <class Keeper>
void compute_contact_forces(const Exec& exec, const MechanicsParameters& parameters, double dt,
                            const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                            const Keeper& accounts);

}  // namespace vug
