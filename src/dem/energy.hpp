#pragma once
// The energy ledger: what was put into the rock and where it is now. Sums in a fixed order: the same bits for any
// number of threads.
#include "dem/accounts.hpp"
#include "dem/contacts.hpp"

#include <optional>

namespace vug {

/// J per m of thickness. `kinetic` and `elastic` are those of this moment; the others are sums since the last reset and
/// are zero when no ledger is kept.
struct Energies {
  double kinetic = 0;
  double elastic = 0;   ///< stored in bonds, closed cracks and contacts
  double initial = 0;   ///< kinetic and elastic at the last reset
  double work = 0;      ///< of loads, fluid, gravity and platens
  double fracture = 0;  ///< released by damage
  double friction = 0;
  double damping = 0;    ///< viscosity of bonds, dashpots of contacts, local damping
  double dissolved = 0;  ///< gone with rock that dissolved (mass_loss.hpp)

  /// What is missing: nothing while cracks neither open nor close (accounts.hpp), else second order in the time step.
  /// Heating at constant opening counts here as well.
  double imbalance() const { return initial + work - kinetic - elastic - fracture - friction - damping - dissolved; }
};

/// Empty accounts.
Accounts make_accounts(const Particles& particles, const Bonds& bonds, const Contacts& contacts);
void reset(const Exec& exec, const Accounts& accounts);

/// Adds everything up half a step before the displacements, where the velocities are, dt being the last step: not for
/// use inside a step.
Energies measure_energies(const Exec& exec, const MechanicsParameters& parameters, double dt,
                          const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                          const std::optional<Accounts>& accounts);

}  // namespace vug
