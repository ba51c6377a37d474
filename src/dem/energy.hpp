#pragma once
// The energy ledger: what was put into the rock and where it is now. Sums are taken in a fixed order, so that the bits
// are the same for any number of threads.
#include "dem/accounts.hpp"
#include "dem/contacts.hpp"

#include <optional>

namespace vug {

/// Energies, J per m of thickness. `kinetic` and `elastic` are current values; the others are sums since the last reset
/// and are zero when no ledger is kept.
struct Energies {
  double kinetic = 0;
  double elastic = 0;   ///< stored in bonds, closed cracks and contacts
  double initial = 0;   ///< kinetic and elastic at the last reset
  double work = 0;      ///< of loads, fluid, gravity and platens
  double fracture = 0;  ///< released by damage
  double friction = 0;
  double damping = 0;    ///< viscosity of bonds, dashpots of contacts, local damping
  double dissolved = 0;  ///< lost with rock that dissolved (mass_loss.hpp)

  /// Error of the ledger: zero while cracks neither open nor close (accounts.hpp), else second order in the time step.
  /// Heating at constant opening also appears here.
  double imbalance() const { return initial + work - kinetic - elastic - fracture - friction - damping - dissolved; }
};

/// Empty accounts.
Accounts make_accounts(const Particles& particles, const Bonds& bonds, const Contacts& contacts);
void reset(const Exec& exec, const Accounts& accounts);

/// Adds everything up at the time of the velocities, half a step before the displacements; `dt` is that of the last
/// step. Not for use inside a step.
Energies measure_energies(const Exec& exec, const MechanicsParameters& parameters, double dt,
                          const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                          const std::optional<Accounts>& accounts);

}  // namespace vug
