#include "dem/forces.hpp"

#include "dem/bond_failure.hpp"
#include "dem/contact_forces.hpp"
#include "dem/gather_contacts.hpp"

namespace vug {

namespace {

/// Contacts beside bonds: they need not know of a bond that fails in this step, since no pair is listed before the
/// first has failed.
template <class Law, class Keeper>
void launch_with(const Exec& exec, const Law& laws, const ContactForces<Keeper>& touch,
                 const MechanicsParameters& parameters, const Groups* awake) {
  const char* label = "vug::dem::forces";
  const BondModel<Law, Keeper> model{laws,     parameters.contact, parameters.chemical, touch.expansion,
                                     touch.dt, touch.particles,    touch.bonds,         touch.accounts};
  const CohesiveForces<Law, Keeper> hold{model};
  const BondFailure<Law, Keeper> fail{model};
  const auto pairs = each(touch.particles.count, touch);
  if (awake)
    launch(exec, label, side_by_side(in_turn(*awake, hold, fail), pairs));
  else
    launch(exec, label, side_by_side(in_turn(touch.bonds.count, hold, fail), pairs));
}

/// What the dashpots of its contacts do to each particle.
template <class Keeper>
void gather_drag(const Exec& exec, const ContactForces<Keeper>& touch) {
  if constexpr (Keeper::kept)
    for_each_node(exec, "vug::dem::gather_drag", touch.particles.count,
                  GatherContacts{touch.bonds, touch.contacts, touch.accounts.pair_drag, touch.accounts.particle_drag});
}

}  // namespace

template <class Keeper>
void compute_forces(const Exec& exec, const MechanicsParameters& parameters, double dt, const Particles& particles,
                    const Bonds& bonds, const Contacts& contacts, const Keeper& accounts, const Groups* awake) {
  const ContactForces<Keeper> touch{
      parameters.contact, parameters.thermal_expansion, dt, particles, bonds, contacts, accounts};
  if (bonds.elasticity.given())
    launch_with(exec, LawOfEach{parameters.bond, bonds.elasticity}, touch, parameters, awake);
  else
    launch_with(exec, OneLaw{parameters.bond}, touch, parameters, awake);
  gather_drag(exec, touch);
}

template <class Keeper>
void compute_contact_forces(const Exec& exec, const MechanicsParameters& parameters, double dt,
                            const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                            const Keeper& accounts) {
  const ContactForces<Keeper> touch{
      parameters.contact, parameters.thermal_expansion, dt, particles, bonds, contacts, accounts};
  launch(exec, "vug::dem::contact_forces", each(particles.count, touch));
  gather_drag(exec, touch);
}

template void compute_forces(const Exec&, const MechanicsParameters&, double, const Particles&, const Bonds&,
                             const Contacts&, const NoAccounts&, const Groups*);
template void compute_forces(const Exec&, const MechanicsParameters&, double, const Particles&, const Bonds&,
                             const Contacts&, const Accounts&, const Groups*);
template void compute_contact_forces(const Exec&, const MechanicsParameters&, double, const Particles&, const Bonds&,
                                     const Contacts&, const Accounts&);

}  // namespace vug
