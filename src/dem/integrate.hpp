#pragma once
// Newton's law for every particle (Eq. 10), leapfrog.
#include "dem/accounts.hpp"
#include "dem/contacts.hpp"
#include "dem/launch_in_turn.hpp"
#include "dem/loads.hpp"

namespace vug {

/// Numbers that control one step.
struct StepControl {
  double dt = 0;             ///< s
  double local_damping = 0;  ///< Cundall's alpha
  double mass_scaling = 1;   ///< of inertia only
  double load_factor = 1;    ///< scales tractions and gravity, for ramps
  double surroundings = 1;   ///< scales the springs of the rock beyond: 0 in a preload, which they would resist
};

/// Gathers the forces on each particle in a fixed order, those of its contacts into Contacts::push, and moves it:
///   v(t + dt/2) = v(t - dt/2) + dt F / m,  u(t + dt) = u(t) + dt v(t + dt/2),
/// and the same for spin and angle. Symplectic. `awake` gives the groups of particles that move; null: all.
template <class Keeper>
void integrate(const Queue& queue, const StepControl& control, const Bonds& bonds, const Contacts& contacts,
               const BoundaryLoads& loads, const Particles& particles, const Keeper& accounts,
               const Groups* awake = nullptr);

}  // namespace vug
