#include "dem/forces.hpp"

#include "dem/bond_failure.hpp"
#include "dem/contact_forces.hpp"
#include "dem/gather_contacts.hpp"

namespace vug {

namespace {

/// Launches contacts beside bonds. Contacts need not know of a bond that fails in this step, because no pair is listed
/// for it before the next search.
template <class Law, class Keeper>
void launch_with(const Queue& queue, BondModel<Law, Keeper> model, ContactForces<Keeper> touch,
                 const ForceGroups& only) {
  const char* label = "vug::dem::forces";
  const int particles = model.particles.count, bonds = model.bonds.count;
  CohesiveForces<Law, Keeper> hold{model};
  BondFailure<Law, Keeper> fail{std::move(model)};
  if (only.pairs)
    return launch(queue, label,
                  side_by_side(in_turn(queue.exec, *only.bonds, std::move(hold), std::move(fail)),
                               each(queue.exec, *only.pairs, std::move(touch))));
  auto pairs = each(particles, std::move(touch));
  if (only.bonds)
    launch(queue, label,
           side_by_side(in_turn(queue.exec, *only.bonds, std::move(hold), std::move(fail)), std::move(pairs)));
  else
    launch(queue, label, side_by_side(in_turn(bonds, std::move(hold), std::move(fail)), std::move(pairs)));
}

/// Sums the dashpots of the contacts of each particle, into particle_drag.
template <class Keeper>
void gather_drag(const Exec& exec, int count, const Bonds& bonds, const Contacts& contacts, const Keeper& accounts) {
  if constexpr (Keeper::kept)
    for_each_node(
        exec, "vug::dem::gather_drag", count,
        GatherContacts{bonds.events, contacts.row, contacts.entry, accounts.pair_drag, accounts.particle_drag});
}

}  // namespace

template <class Keeper>
void compute_forces(const Queue& queue, const MechanicsParameters& parameters, double dt, const Particles& particles,
                    const Bonds& bonds, const Contacts& contacts, const Keeper& accounts, const ForceGroups& only) {
  const double expansion = parameters.thermal_expansion;
  const auto launch_law = [&](auto law) {
    launch_with(
        queue,
        BondModel<decltype(law), Keeper>{std::move(law), parameters.contact, ChemicalFactors(parameters.chemical),
                                         expansion, dt, particles, bonds, accounts},
        ContactForces<Keeper>{parameters.contact, expansion, dt, particles, contacts, accounts}, only);
  };
  if (bonds.elasticity.given())
    launch_law(LawOfEach{parameters.bond, bonds.elasticity});
  else
    launch_law(OneLaw{parameters.bond});
  gather_drag(queue.exec, particles.count, bonds, contacts, accounts);
}

template <class Keeper>
void compute_contact_forces(const Exec& exec, const MechanicsParameters& parameters, double dt,
                            const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                            const Keeper& accounts) {
  for_each_node(
      exec, "vug::dem::contact_forces", particles.count,
      ContactForces<Keeper>{parameters.contact, parameters.thermal_expansion, dt, particles, contacts, accounts});
  gather_drag(exec, particles.count, bonds, contacts, accounts);
}

VUG_COMPILE(compute_forces<NoAccounts>)
VUG_COMPILE(compute_forces<Accounts>)
VUG_COMPILE(compute_contact_forces<Accounts>)

}  // namespace vug
