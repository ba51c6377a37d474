#include "dem/bond_forces.hpp"

#include "dem/bond_elasticity.hpp"
#include "dem/bond_kinematics.hpp"
#include "dem/bond_law.hpp"
#include "dem/contact_law.hpp"
#include "kernels/launch_in_turn.hpp"

namespace vug {

namespace {

/// Stress at an integration point, on the face of a: tension and the direction of t positive, Pa.
struct PointStress {
  double normal = 0;
  double tangential = 0;
  double slip = 0;  ///< of a crack: where its slider stands afterwards, m
};

/// What both kernels of a bond need: its stress and energy while it holds, and the way in which they leave forces.
template <class Law, class Keeper>
struct BondModel {
  Law laws;
  ContactParameters contact;
  ChemicalDamageLaw chemical;
  double expansion;
  double dt;
  Particles particles;
  Bonds bonds;
  Keeper accounts;

  KOKKOS_FORCEINLINE_FUNCTION double chemical_damage(int k) const {
    const double d_c = bonds.d_c(k);
    return d_c < 1 ? d_c : 1.0;
  }

  /// Stiffness and strengths of the bond at its chemical damage; sigma_t holds the cohesion alone.
  KOKKOS_FORCEINLINE_FUNCTION BondPoint material(int k, double d_c) const {
    const BondParameters& law = laws.of(k);
    const double inverse_length = 1 / (law.length_factor * bonds.spacing(k));
    const double f1 = chemical_strength_factor(d_c, chemical.normalised);
    const double f2 = chemical_energy_factor(d_c, chemical.normalised);
    return {law.normal_modulus * (1 - d_c) * inverse_length,
            law.tangential_modulus * (1 - d_c) * inverse_length,
            f1 * bonds.normal_strength(k),
            f1 * bonds.cohesion(k),
            f2 * bonds.energy_I(k),
            f2 * bonds.energy_II(k)};
  }

  /// The same with the shear strength at this opening.
  KOKKOS_FORCEINLINE_FUNCTION BondPoint pressed(int k, BondPoint point, const PointOpening& o) const {
    point.sigma_t =
        shear_strength(point.sigma_t, laws.of(k).internal_friction, point.k_n * (o.delta_n < 0 ? o.delta_n : 0));
    return point;
  }

  /// Of a bond with damage d_m and d_c.
  KOKKOS_FORCEINLINE_FUNCTION PointStress stress_of(int k, const BondPoint& point, double d_m, double d_c,
                                                    const PointOpening& o) const {
    const BondParameters& law = laws.of(k);
    const double viscous = law.damping * (1 - d_c);
    return {normal_integrity(d_m, o.delta_n) * (point.k_n * o.delta_n + viscous * law.normal_modulus * o.rate_n),
            (1 - d_m) * (point.k_t * o.delta_t + viscous * law.tangential_modulus * o.rate_t), 0};
  }

  /// Stored energy that new damage releases, and what viscosity takes; nothing for a bond that failed before.
  KOKKOS_FORCEINLINE_FUNCTION void keep_cohesive(int k, const BondPoint& material, const double (&damage)[2],
                                                 const PointOpening (&opening)[2],
                                                 const PointStress (&stress)[2]) const {
    if (has_failed(bonds.state(k))) return;
    const BondMotion before = motion_of_bond_before(particles, bonds, expansion, dt, k);
    double fracture = 0, viscous = 0;
    for (int s = 0; s < 2; ++s) {
      const PointOpening &o = opening[s], &b = before.opening[s];
      fracture += (damage[s] - bonds.point_damage(k, s)) *
                  undamaged_energy(material, o.delta_n, b.delta_n, o.delta_t, b.delta_t);
      const double drag_n = stress[s].normal - normal_integrity(damage[s], o.delta_n) * material.k_n * o.delta_n;
      const double drag_t = stress[s].tangential - (1 - damage[s]) * material.k_t * o.delta_t;
      viscous +=
          (accounts.drag_before(k, s, 0) + drag_n) * o.rate_n + (accounts.drag_before(k, s, 1) + drag_t) * o.rate_t;
      accounts.keep_drag(k, s, drag_n, drag_t);
    }
    const double width = 0.5 * bonds.length(k);
    accounts.add_bond(k, width * fracture, 0, 0.5 * dt * width * viscous);
  }

  KOKKOS_FORCEINLINE_FUNCTION void store(int k, const BondMotion& motion, const PointStress (&stress)[2]) const {
    const double width = 0.5 * bonds.length(k);
    const Vec2 n = motion.frame.n(), t = motion.frame.t();
    const Vec2 first = width * (stress[0].normal * n + stress[0].tangential * t);
    const Vec2 second = width * (stress[1].normal * n + stress[1].tangential * t);
    const Vec2 force = first + second;
    bonds.load(k, 0) = force.x;
    bonds.load(k, 1) = force.y;
    bonds.load(k, 2) = cross(motion.opening[0].arm_a, first) + cross(motion.opening[1].arm_a, second);
    bonds.load(k, 3) = -cross(motion.opening[0].arm_b, first) - cross(motion.opening[1].arm_b, second);
    bonds.stress(k, 0) = 0.5 * (stress[0].normal + stress[1].normal);
    bonds.stress(k, 1) = 0.5 * (stress[0].tangential + stress[1].tangential);
  }
};

/// One bond as if it held: opening at two Gauss points and stress with viscosity eta M v (Eq. 12), forces and torques
/// on both ends at the midpoint of the opening. No branches, so that a host computes eight bonds at once: whether a
/// point asks for more damage is told by products alone, and the law of damage, which is all quotients and roots, is
/// left to BondFailure, as are bonds that have failed. Reads about 25 numbers of the bond and 18 of its particles,
/// writes 7; the forces of the two ends cancel exactly.
template <class Law, class Keeper>
struct CohesiveForces {
  BondModel<Law, Keeper> model;

  KOKKOS_FORCEINLINE_FUNCTION bool asks_for_damage(int k, int s, const BondPoint& material,
                                                   const PointOpening& o) const {
    return is_overstressed(model.pressed(k, material, o), o.delta_n, o.delta_t) & (model.bonds.point_damage(k, s) < 1);
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int k) const {
    const Bonds& bonds = model.bonds;
    const BondMotion motion = motion_of_bond(model.particles, bonds, model.expansion, k);
    const double d_c = model.chemical_damage(k);
    const BondPoint material = model.material(k, d_c);
    const double damage[2] = {bonds.point_damage(k, 0), bonds.point_damage(k, 1)};
    const PointStress stress[2] = {model.stress_of(k, material, damage[0], d_c, motion.opening[0]),
                                   model.stress_of(k, material, damage[1], d_c, motion.opening[1])};
    const bool more =
        asks_for_damage(k, 0, material, motion.opening[0]) | asks_for_damage(k, 1, material, motion.opening[1]);
    bonds.overstressed(k) = more ? 1 : 0;
    if constexpr (Keeper::kept)
      if (!more) model.keep_cohesive(k, material, damage, motion.opening, stress);
    model.store(k, motion, stress);
  }
};

/// The bonds to which something happens: damages those that are overstressed, names the mode of first damage, fails a
/// bond whose two points are broken or whose solid is dissolved, and replaces the forces of a failed one by those of a
/// crack, whose faces press and rub at the same two points with the bond's own stiffness and the contact's friction and
/// dashpot, all in the share that dissolution has left.
template <class Law, class Keeper>
struct BondFailure {
  BondModel<Law, Keeper> model;

  /// An overstressed bond: damage by the unified linear law (Eqs. 11, 26-29), and the stress it leaves.
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

  /// The sliders of the new crack stand where its faces are.
  KOKKOS_FUNCTION void fail(int k, const BondMotion& motion) const {
    if constexpr (Keeper::kept) close_account(k, motion);
    for (int s = 0; s < 2; ++s) model.bonds.slip(k, s) = motion.opening[s].delta_t;
    Kokkos::atomic_store(&model.bonds.events(bond_has_failed), 1);
    Kokkos::atomic_store(&model.bonds.events(cracks_have_changed), 1);
  }

  /// Releases what a dissolved bond still holds, and takes back the viscosity of this step: a crack has none.
  KOKKOS_FUNCTION void close_account(int k, const BondMotion& motion) const {
    const BondPoint material = model.material(k, model.chemical_damage(k));
    const BondMotion before = motion_of_bond_before(model.particles, model.bonds, model.expansion, model.dt, k);
    double released = 0, viscous = 0;
    for (int s = 0; s < 2; ++s) {
      const PointOpening &o = motion.opening[s], &b = before.opening[s];
      released +=
          (1 - model.bonds.point_damage(k, s)) * undamaged_energy(material, o.delta_n, b.delta_n, o.delta_t, b.delta_t);
      viscous += model.accounts.drag_before(k, s, 0) * o.rate_n + model.accounts.drag_before(k, s, 1) * o.rate_t;
      model.accounts.keep_drag(k, s, 0, 0);
    }
    const double width = 0.5 * model.bonds.length(k);
    model.accounts.add_bond(k, width * released, 0, -0.5 * model.dt * width * viscous);
  }

  KOKKOS_FUNCTION BondState settled(int k, BondState state, const BondMotion& motion) const {
    const double d_m = model.bonds.d_m(k);
    if (state == BondState::intact && d_m > 0) state = first_damage(k, motion);
    if (d_m < 1 && model.bonds.d_c(k) < model.chemical.failure_at) return state;
    fail(k, motion);
    if (d_m < 1) return BondState::dissolved;
    return state == BondState::damaged_in_tension ? BondState::failed_in_tension : BondState::failed_in_shear;
  }

  /// The two-point law of crack faces holds while they lie opposite each other and something is left of them.
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

  /// What slider and dashpots of a crack take; `fresh` when it was a bond before this step. The stretch that a crack
  /// loses when it opens counts as friction.
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

  KOKKOS_FUNCTION void operator()(int k) const {
    BondState state = model.bonds.state(k);
    const bool overstressed = model.bonds.overstressed(k) != 0;
    const bool quiet = !overstressed && model.bonds.d_m(k) == 0 && model.bonds.d_c(k) < model.chemical.failure_at;
    if (!has_failed(state) && quiet) return;
    const BondMotion motion = motion_of_bond(model.particles, model.bonds, model.expansion, k);
    const bool fresh = !has_failed(state);
    if (fresh && overstressed) take_damage(k, motion);
    if (fresh) {
      state = settled(k, state, motion);
      model.bonds.state(k) = state;
    }
    if (!has_failed(state)) return;
    PointStress stress[2];
    if (faces_meet(k, motion.opening)) {
      const BondPoint point = model.material(k, model.chemical_damage(k));
      for (int s = 0; s < 2; ++s) stress[s] = crack_stress(k, s, point, motion.opening[s]);
      if constexpr (Keeper::kept) keep_account(k, point, motion, stress, fresh);
      for (int s = 0; s < 2; ++s) model.bonds.slip(k, s) = stress[s].slip;
    }
    model.store(k, motion, stress);
  }
};

template <class Law, class Keeper>
void launch(const Exec& exec, const Law& laws, const MechanicsParameters& parameters, double dt,
            const Particles& particles, const Bonds& bonds, const Keeper& accounts, const Groups* awake) {
  const char* label = "vug::dem::bond_forces";
  const BondModel<Law, Keeper> model{
      laws, parameters.contact, parameters.chemical, parameters.thermal_expansion, dt, particles, bonds, accounts};
  const CohesiveForces<Law, Keeper> hold{model};
  const BondFailure<Law, Keeper> fail{model};
  if (awake)
    for_each_group_in_turn(exec, label, *awake, hold, fail);
  else
    for_each_node_in_turn(exec, label, bonds.count, hold, fail);
}

}  // namespace

template <class Keeper>
void compute_bond_forces(const Exec& exec, const MechanicsParameters& parameters, double dt, const Particles& particles,
                         const Bonds& bonds, const Keeper& accounts, const Groups* awake) {
  if (bonds.elasticity.given())
    launch(exec, LawOfEach{parameters.bond, bonds.elasticity}, parameters, dt, particles, bonds, accounts, awake);
  else
    launch(exec, OneLaw{parameters.bond}, parameters, dt, particles, bonds, accounts, awake);
}

template void compute_bond_forces(const Exec&, const MechanicsParameters&, double, const Particles&, const Bonds&,
                                  const NoAccounts&, const Groups*);
template void compute_bond_forces(const Exec&, const MechanicsParameters&, double, const Particles&, const Bonds&,
                                  const Accounts&, const Groups*);

}  // namespace vug
