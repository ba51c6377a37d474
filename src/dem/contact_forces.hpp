#pragma once
// Forces of triangles that touch without being bonded, each pair into its own slot.
#include "dem/accounts.hpp"
#include "dem/contacts.hpp"

namespace vug {

/// Evaluates every candidate pair at the current displacements and velocities, advances its friction springs by dt,
/// writes Contacts::load, which the integrator gathers into Contacts::push.
template <class Keeper>
void compute_contact_forces(const Exec& exec, const MechanicsParameters& parameters, double dt,
                            const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                            const Keeper& accounts);

}  // namespace vug
