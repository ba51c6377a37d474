#pragma once
// Elastic energy of a bond or of the faces of a crack.
#include "dem/bond_elasticity.hpp"
#include "dem/bond_kinematics.hpp"
#include "dem/bond_law.hpp"

namespace vug {

/// (1 - d) (k_n delta_n delta_n' + k_t delta_t delta_t') / 2 over the edge of one bond, with delta at the time of the
/// last forces and delta' one step later; for a crack, the energy of its compression and of the stretch of its friction
/// spring. J per m.
struct ElasticEnergy {
  BondParameters rock;
  double expansion;
  double dt;
  Particles particles;
  Bonds bonds;

  /// The same per share of the solid that is left, 1 - d_c.
  KOKKOS_FUNCTION double undissolved(int k) const {
    if (bonds.joint(k) == faces_apart) return 0;
    const BondParameters law = law_of(rock, bonds.elasticity, k);
    const BondMotion now = motion_of_bond(particles, bonds, expansion, k);
    const BondMotion before = motion_of_bond_before(particles, bonds, expansion, dt, k);
    const double length = law.length_factor * bonds.spacing(k);
    const bool failed = has_failed(bonds.state(k));
    double sum = 0;
    for (int s = 0; s < 2; ++s) {
      const PointOpening &o = now.opening[s], &b = before.opening[s];
      const double d_m = failed ? 1 : bonds.point_damage(k, s);
      const double slip = failed ? bonds.slip(k, s) : 0;
      const double held = !failed ? 1 - d_m : b.delta_n < 0 ? 1 : 0;
      sum += normal_integrity(d_m, b.delta_n) * law.normal_modulus * b.delta_n * o.delta_n +
             held * law.tangential_modulus * (b.delta_t - slip) * (o.delta_t - slip);
    }
    return 0.25 * bonds.length(k) / length * sum;
  }
  KOKKOS_FUNCTION double operator()(int k) const { return (1 - at_most(1, bonds.d_c(k))) * undissolved(k); }
};

}  // namespace vug
