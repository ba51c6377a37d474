#include "dem/bond_forces.hpp"

#include "dem/bond_kinematics.hpp"
#include "dem/bond_law.hpp"
#include "dem/contact_law.hpp"
#include "kernels/launch.hpp"

namespace vug {

namespace {

/// Stress at an integration point, on the face of a: tension and the direction of t positive, Pa.
struct PointStress {
  double normal = 0;
  double tangential = 0;
};

/// One bond: opening at two Gauss points, damage by the unified linear law (Eqs. 11, 12, 26-29), stress with viscosity
/// eta M v, forces and torques on both ends at the midpoint of the opening. A failed bond is a crack whose faces press
/// and rub at the same two points with the bond's own stiffness and the contact's friction and dashpot.
/// Reads about 45 numbers of the bond and 20 of its particles, writes 6; forces of the two ends add up to zero exactly.
struct BondForces {
  BondParameters law;
  ContactParameters contact;
  ChemicalDamageLaw chemical;
  double expansion;
  Particles particles;
  Bonds bonds;

  KOKKOS_FUNCTION BondPoint undamaged_point(int k, double d_c) const {
    const double length = law.length_factor * bonds.spacing(k);
    const double f1 = chemical_strength_factor(d_c, chemical.normalised);
    const double f2 = chemical_energy_factor(d_c, chemical.normalised);
    return {law.normal_modulus * (1 - d_c) / length,
            law.tangential_modulus * (1 - d_c) / length,
            f1 * bonds.normal_strength(k),
            f1 * bonds.cohesion(k),
            f2 * bonds.energy_I(k),
            f2 * bonds.energy_II(k)};
  }

  KOKKOS_FUNCTION void damage_point(int k, int s, BondPoint point, double cohesion, const PointOpening& o,
                                    BondState& state) const {
    point.sigma_t = shear_strength(cohesion, law.internal_friction, point.k_n * Kokkos::min(0.0, o.delta_n));
    const double asked = damage_of_opening(point, o.delta_n, o.delta_t);
    if (asked <= bonds.point_damage(k, s)) return;
    bonds.point_damage(k, s) = asked;
    if (state == BondState::intact) {
      state =
          onset_in_tension(point, o.delta_n, o.delta_t) ? BondState::damaged_in_tension : BondState::damaged_in_shear;
    }
  }

  KOKKOS_FUNCTION PointStress cohesive_stress(int k, int s, const BondPoint& point, double d_c,
                                              const PointOpening& o) const {
    const double d_m = bonds.point_damage(k, s);
    const double normal = normal_integrity(d_m, o.delta_n);
    const double viscous = law.damping * (1 - d_c);
    return {normal * (point.k_n * o.delta_n + viscous * law.normal_modulus * o.rate_n),
            (1 - d_m) * (point.k_t * o.delta_t + viscous * law.tangential_modulus * o.rate_t)};
  }

  /// The two-point law of crack faces holds while they lie opposite each other.
  KOKKOS_FUNCTION bool faces_meet(int k, const PointOpening (&opening)[2]) const {
    if (bonds.joint(k) == 0) return false;
    const double apart = 0.5 * Kokkos::max(opening[0].delta_n + opening[1].delta_n,
                                           Kokkos::abs(opening[0].delta_t + opening[1].delta_t));
    if (apart < 0.5 * bonds.length(k)) return true;
    bonds.joint(k) = 0;
    Kokkos::atomic_store(&bonds.events(crack_has_parted), 1);
    return false;
  }

  KOKKOS_FUNCTION PointStress crack_stress(int k, int s, const BondPoint& point, const PointOpening& o) const {
    const double width = 0.5 * bonds.length(k);
    const ContactPoint joint{point.k_n, point.k_t, contact.normal_damping / width, contact.tangential_damping / width,
                             contact.friction};
    const ContactReaction reaction =
        contact_reaction(joint, -o.delta_n, -o.rate_n, o.delta_t, o.rate_t, bonds.slip(k, s));
    bonds.slip(k, s) = reaction.slip;
    return {-reaction.normal, -reaction.tangential};
  }

  KOKKOS_FUNCTION void settle_state(int k, double d_c, BondState& state, const PointOpening (&opening)[2]) const {
    const double d_m = 0.5 * (bonds.point_damage(k, 0) + bonds.point_damage(k, 1));
    const bool dissolved = d_c >= chemical.failure_at;
    if (d_m >= 1 || dissolved) {
      state = d_m < 1                                  ? BondState::dissolved
              : state == BondState::damaged_in_tension ? BondState::failed_in_tension
                                                       : BondState::failed_in_shear;
      for (int s = 0; s < 2; ++s) {
        bonds.point_damage(k, s) = 1;
        bonds.slip(k, s) = opening[s].delta_t;
      }
      Kokkos::atomic_store(&bonds.events(bond_has_failed), 1);
    }
    bonds.d_m(k) = has_failed(state) ? 1 : d_m;
  }

  KOKKOS_FUNCTION void store(int k, const BondFrame& frame, const PointOpening (&opening)[2],
                             const PointStress (&stress)[2]) const {
    const double width = 0.5 * bonds.length(k);
    Vec2 force;
    double torque_a = 0, torque_b = 0;
    for (int s = 0; s < 2; ++s) {
      const Vec2 f = width * (stress[s].normal * frame.n + stress[s].tangential * frame.t);
      force = force + f;
      torque_a += cross(opening[s].arm_a, f);
      torque_b -= cross(opening[s].arm_b, f);
    }
    bonds.load(k, 0) = force.x;
    bonds.load(k, 1) = force.y;
    bonds.load(k, 2) = torque_a;
    bonds.load(k, 3) = torque_b;
    bonds.stress(k, 0) = 0.5 * (stress[0].normal + stress[1].normal);
    bonds.stress(k, 1) = 0.5 * (stress[0].tangential + stress[1].tangential);
  }

  KOKKOS_FUNCTION void operator()(int k) const {
    const auto [frame, opening] = motion_of_bond(particles, bonds, expansion, k);
    const double d_c = Kokkos::min(bonds.d_c(k), chemical.failure_at);
    const BondPoint point = undamaged_point(k, d_c);
    BondState state = bonds.state(k);
    if (!has_failed(state)) {
      for (int s = 0; s < 2; ++s) damage_point(k, s, point, point.sigma_t, opening[s], state);
      settle_state(k, d_c, state, opening);
      bonds.state(k) = state;
    }
    PointStress stress[2];
    if (!has_failed(state)) {
      for (int s = 0; s < 2; ++s) stress[s] = cohesive_stress(k, s, point, d_c, opening[s]);
    } else if (faces_meet(k, opening)) {
      for (int s = 0; s < 2; ++s) stress[s] = crack_stress(k, s, point, opening[s]);
    }
    store(k, frame, opening, stress);
  }
};

}  // namespace

void compute_bond_forces(const Exec& exec, const MechanicsParameters& parameters, const Particles& particles,
                         const Bonds& bonds) {
  for_each_node(exec, "vug::dem::bond_forces", bonds.count,
                BondForces{parameters.bond, parameters.contact, parameters.chemical, parameters.thermal_expansion,
                           particles, bonds});
}

}  // namespace vug
