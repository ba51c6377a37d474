#pragma once
// Damage and failure of overstressed bonds, and the cracks that they become.
#include "dem/bond_model.hpp"
#include "dem/contact_law.hpp"

namespace vug {

// Used by forces.cpp only. With external names less of this would be inlined, which costs time and changes last bits.
namespace {

/// Treats the bonds that change or have failed. It damages those that are overstressed, records the mode of the first
/// damage, and fails a bond whose two points are broken or whose solid is dissolved. The forces of a failed bond are
/// replaced by those of a crack: its faces press and rub at the same two points with the bond's own stiffness and the
/// contact's friction and dashpot, all times the share that dissolution has left.
template <class Law, class Keeper>
struct BondFailure {
  BondModel<Law, Keeper> model;

  /// Damages an overstressed bond by the unified linear law (Eqs. 11, 26-29) and stores the stress that this leaves.
  KOKKOS_FUNCTION void take_damage(int k, const BondMotion& motion) const {
    const Bonds& bonds = model.bonds;
    const double d_c = model.chemical_damage(k);
    const BondPoint material = model.material(k, d_c);
    double damage[2];
    PointStress stress[2];
    for (int s = 0; s < 2; ++s) {
      const PointOpening& o = motion.opening[s];
      damage[s] =
          at_least(bonds.point_damage(k, s), damage_of_opening(model.pressed(k, material, o), o.delta_n, o.delta_t));
      stress[s] = model.stress_of(k, material, damage[s], d_c, o);
    }
    if constexpr (Keeper::kept) model.keep_cohesive(k, material, damage, motion.opening, stress);
    bonds.point_damage(k, 0) = damage[0];
    bonds.point_damage(k, 1) = damage[1];
    bonds.d_m(k) = 0.5 * (damage[0] + damage[1]);
    model.store(k, motion, stress);
  }

  KOKKOS_FUNCTION BondState first_damage(int k, const BondMotion& motion) const {
    const int s = model.bonds.point_damage(k, 0) > 0 ? 0 : 1;
    const PointOpening& o = motion.opening[s];
    const BondPoint point = model.pressed(k, model.material(k, model.chemical_damage(k)), o);
    return onset_in_tension(point, o.delta_n, o.delta_t) ? BondState::damaged_in_tension : BondState::damaged_in_shear;
  }

  /// Turns a bond into a crack; the sliders start where the faces are.
  KOKKOS_FUNCTION void fail(int k, const BondMotion& motion) const {
    if constexpr (Keeper::kept) close_account(k, motion);
    for (int s = 0; s < 2; ++s) model.bonds.slip(k, s) = motion.opening[s].delta_t;
    Kokkos::atomic_store(&model.bonds.events(bond_has_failed), 1);
    Kokkos::atomic_store(&model.bonds.events(cracks_have_changed), 1);
  }

  /// The half step of work that the dashpots of the step before still do in this one, J per m; they are then forgotten.
  KOKKOS_FUNCTION double take_last_drag(int k, const BondMotion& motion) const {
    double power = 0;
    for (int s = 0; s < 2; ++s) {
      const PointOpening& o = motion.opening[s];
      power += model.accounts.drag_before(k, s, 0) * o.rate_n + model.accounts.drag_before(k, s, 1) * o.rate_t;
      model.accounts.keep_drag(k, s, 0, 0);
    }
    return 0.25 * model.dt * model.bonds.length(k) * power;
  }

  /// Releases the energy that a dissolved bond still stores, and takes back the viscous work of this step, because a
  /// crack has no viscosity.
  KOKKOS_FUNCTION void close_account(int k, const BondMotion& motion) const {
    const BondPoint material = model.material(k, model.chemical_damage(k));
    const BondMotion before = motion_of_bond_before(model.particles, model.bonds, model.expansion, model.dt, k);
    double released = 0;
    for (int s = 0; s < 2; ++s) {
      const PointOpening &o = motion.opening[s], &b = before.opening[s];
      released +=
          (1 - model.bonds.point_damage(k, s)) * undamaged_energy(material, o.delta_n, b.delta_n, o.delta_t, b.delta_t);
    }
    model.accounts.add_bond(k, 0.5 * model.bonds.length(k) * released, 0, -take_last_drag(k, motion));
  }

  KOKKOS_FUNCTION BondState settled(int k, BondState state, const BondMotion& motion) const {
    const double d_m = model.bonds.d_m(k);
    if (state == BondState::intact && d_m > 0) state = first_damage(k, motion);
    if (d_m < 1 && model.bonds.d_c(k) < model.chemical.failure_at) return state;
    fail(k, motion);
    if (d_m < 1) return BondState::dissolved;
    return state == BondState::damaged_in_tension ? BondState::failed_in_tension : BondState::failed_in_shear;
  }

  /// Whether the two-point law of crack faces applies: while they are opposite each other and something is left of
  /// them. Updates `joint`.
  KOKKOS_FUNCTION bool faces_meet(int k, const PointOpening (&opening)[2]) const {
    const Bonds& bonds = model.bonds;
    const std::uint8_t before = bonds.joint(k);
    if (before == faces_apart) return false;
    const double apart = 0.5 * Kokkos::max(opening[0].delta_n + opening[1].delta_n,
                                           Kokkos::abs(opening[0].delta_t + opening[1].delta_t));
    const std::uint8_t now = !(apart < 0.5 * bonds.length(k))            ? faces_apart
                             : bonds.d_c(k) >= model.chemical.failure_at ? faces_dissolved
                                                                         : before;
    if (now != before) Kokkos::atomic_store(&bonds.events(cracks_have_changed), 1);
    bonds.joint(k) = now;
    return now != faces_apart && bonds.d_c(k) < 1;
  }

  KOKKOS_FUNCTION PointStress crack_stress(int k, int s, const BondPoint& point, const PointOpening& o) const {
    const ContactParameters& c = model.contact;
    const double width = 0.5 * model.bonds.length(k), left = 1 - model.chemical_damage(k);
    const ContactPoint joint{point.k_n, point.k_t, left * c.normal_damping / width, left * c.tangential_damping / width,
                             c.friction};
    const ContactReaction reaction =
        contact_reaction(joint, -o.delta_n, -o.rate_n, o.delta_t, o.rate_t, model.bonds.slip(k, s));
    return {-reaction.normal, -reaction.tangential, reaction.slip};
  }

  /// Books what sliders and dashpots of a crack take; `fresh` if it was a bond before this step. The stretch that a
  /// crack loses when it opens counts as friction.
  KOKKOS_FUNCTION void keep_account(int k, const BondPoint& point, const BondMotion& motion,
                                    const PointStress (&stress)[2], bool fresh) const {
    const BondMotion before = motion_of_bond_before(model.particles, model.bonds, model.expansion, model.dt, k);
    double friction = 0, damped = 0;
    for (int s = 0; s < 2; ++s) {
      const PointOpening &o = motion.opening[s], &b = before.opening[s];
      const double slip = stress[s].slip, slip_before = model.bonds.slip(k, s);
      const double stretch = o.delta_t - slip, stretch_before = fresh ? 0 : b.delta_t - slip_before;
      friction += 0.5 * point.k_t * (stretch_before * (o.delta_t - slip_before) + stretch * (slip - b.delta_t));
      const double drag_n = stress[s].normal - point.k_n * at_most(0, o.delta_n);
      const double drag_t = stress[s].tangential - point.k_t * stretch;
      damped += (model.accounts.drag_before(k, s, 0) + drag_n) * o.rate_n +
                (model.accounts.drag_before(k, s, 1) + drag_t) * o.rate_t;
      model.accounts.keep_drag(k, s, drag_n, drag_t);
    }
    const double width = 0.5 * model.bonds.length(k);
    model.accounts.add_bond(k, 0, width * friction, 0.5 * model.dt * width * damped);
  }

  /// Books as friction what the faces of a crack store when they have slid past each other: outlines bear the two from
  /// then on, without what the faces have borne (Contacts::idle_overlap).
  KOKKOS_FUNCTION void let_go_of_faces(int k, const BondMotion& motion) const {
    const BondPoint point = model.material(k, model.chemical_damage(k));
    const BondMotion before = motion_of_bond_before(model.particles, model.bonds, model.expansion, model.dt, k);
    double stored = 0;
    for (int s = 0; s < 2; ++s) {
      const PointOpening &o = motion.opening[s], &b = before.opening[s];
      const double slip = model.bonds.slip(k, s);
      if (b.delta_n < 0)
        stored += 0.5 * (point.k_n * b.delta_n * o.delta_n + point.k_t * (b.delta_t - slip) * (o.delta_t - slip));
    }
    model.accounts.add_bond(k, 0, 0.5 * model.bonds.length(k) * stored, take_last_drag(k, motion));
  }

  /// Most bonds are neither damaged nor overstressed: this is all that is done for them.
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int k) const {
    const BondState state = model.bonds.state(k);
    const bool overstressed = model.bonds.overstressed(k) != 0;
    const bool quiet = !overstressed && model.bonds.d_m(k) == 0 && model.bonds.d_c(k) < model.chemical.failure_at;
    if (has_failed(state) || !quiet) treat(k, state, overstressed);
  }

  KOKKOS_FUNCTION void treat(int k, BondState state, bool overstressed) const {
    const BondMotion motion = motion_of_bond(model.particles, model.bonds, model.expansion, k);
    const bool fresh = !has_failed(state);
    if (fresh && overstressed) take_damage(k, motion);
    if (fresh) {
      state = settled(k, state, motion);
      model.bonds.state(k) = state;
    }
    if (!has_failed(state)) return;
    PointStress stress[2];
    const bool were_apart = model.bonds.joint(k) == faces_apart;
    if (faces_meet(k, motion.opening)) {
      const BondPoint point = model.material(k, model.chemical_damage(k));
      for (int s = 0; s < 2; ++s) stress[s] = crack_stress(k, s, point, motion.opening[s]);
      if constexpr (Keeper::kept) keep_account(k, point, motion, stress, fresh);
      for (int s = 0; s < 2; ++s) model.bonds.slip(k, s) = stress[s].slip;
    } else if constexpr (Keeper::kept) {
      if (!fresh && !were_apart && model.bonds.joint(k) == faces_apart) let_go_of_faces(k, motion);
    }
    model.store(k, motion, stress);
  }
};

}  // namespace

}  // namespace vug
