#pragma once
// Forces of triangles that touch without being bonded, each pair into its own slot.
#include "dem/contacts.hpp"

namespace vug {

/// Evaluates every candidate pair at the current displacements and velocities, advances its friction springs by dt and
/// writes Contacts::load.
void compute_contact_forces(const Exec& exec, const MechanicsParameters& parameters, double dt,
                            const Particles& particles, const Bonds& bonds, const Contacts& contacts);

}  // namespace vug
