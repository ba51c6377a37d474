#pragma once
// Stress of a bond that has not failed, and the forces that it exerts on its ends.
#include "dem/accounts.hpp"
#include "dem/bond_elasticity.hpp"
#include "dem/bond_kinematics.hpp"
#include "dem/bond_law.hpp"

namespace vug {

// Used by forces.cpp only. With external names less of this would be inlined, which costs time and changes last bits.
namespace {

/// Stress at an integration point, on the face of a: tension and the direction of t positive, Pa.
struct PointStress {
  double normal = 0;
  double tangential = 0;
  double slip = 0;  ///< of a crack: position of its slider afterwards, m
};

/// The common part of both kernels of bonds: stress and energy of a bond that has not failed, and how forces are
/// stored.
template <class Law, class Keeper>
struct BondModel {
  Law laws;
  ContactParameters contact;
  ChemicalFactors chemical;
  double expansion;
  double dt;
  Particles particles;
  Bonds bonds;
  Keeper accounts;

  KOKKOS_FORCEINLINE_FUNCTION double chemical_damage(int k) const {
    const double d_c = bonds.d_c(k);
    return d_c < 1 ? d_c : 1.0;
  }

  /// Stiffness and strengths of the bond at its chemical damage; sigma_t is only the cohesion.
  KOKKOS_FORCEINLINE_FUNCTION BondPoint material(int k, double d_c) const {
    const BondParameters& law = laws.of(k);
    const double inverse_length = 1 / (law.length_factor * bonds.spacing(k));
    const double f1 = chemical.strength(d_c);
    const double f2 = chemical.energy(d_c);
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

  /// Stress of a bond with damage d_m and d_c.
  KOKKOS_FORCEINLINE_FUNCTION PointStress stress_of(int k, const BondPoint& point, double d_m, double d_c,
                                                    const PointOpening& o) const {
    const BondParameters& law = laws.of(k);
    const double viscous = law.damping * (1 - d_c);
    return {normal_integrity(d_m, o.delta_n) * (point.k_n * o.delta_n + viscous * law.normal_modulus * o.rate_n),
            (1 - d_m) * (point.k_t * o.delta_t + viscous * law.tangential_modulus * o.rate_t), 0};
  }

  /// Books the stored energy that new damage releases and what viscosity takes; nothing for a bond that failed before.
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

/// Computes one bond as if it had not failed: opening at two Gauss points and stress with viscosity eta M v (Eq. 12),
/// forces and torques on both ends at the midpoint of the opening. It has no branches, so that a host computes eight
/// bonds at once. Products alone show whether a point needs more damage; the law of damage, which consists of quotients
/// and roots, is left to BondFailure, as are bonds that have failed. Reads about 25 numbers of the bond and 18 of its
/// particles, writes 7. The forces on the two ends cancel exactly.
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

}  // namespace

}  // namespace vug
