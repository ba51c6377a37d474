#pragma once
// Young's modulus and Poisson's ratio of bonded rock, and the moduli of the bonds for given ones.
#include "dem/parameters.hpp"

#include <cmath>

namespace vug {

/// Elasticity of an isotropic plate in plane stress.
struct Elasticity {
  double young_modulus = 0;  ///< Pa
  double poisson_ratio = 0;
};

/// Elasticity of bonded rock, with r = M_t / M_n:
///   E / (1 - nu) = M_n / chi,  E / (1 + nu) = (2 / chi) M_n M_t / (M_n + M_t),  that is nu = (1 - r) / (1 + 3 r).
/// Each triangle is held by three bonds, so that one uniform stress balances it; averaging over all directions of the
/// edges gives these compliances (Reuss). The first is exact, the second within 2 % (docs/validation.md).
constexpr Elasticity elasticity_of(const BondParameters& bond) {
  const double ratio = bond.tangential_modulus / bond.normal_modulus;
  const double nu = (1 - ratio) / (1 + 3 * ratio);
  return {(1 - nu) * bond.normal_modulus / bond.length_factor, nu};
}

/// Bonds with the moduli that give the rock this elasticity: M_n = chi E / (1 - nu), M_t = chi E / (1 + 3 nu).
constexpr BondParameters with_elasticity(BondParameters bond, const Elasticity& rock) {
  bond.normal_modulus = bond.length_factor * rock.young_modulus / (1 - rock.poisson_ratio);
  bond.tangential_modulus = bond.length_factor * rock.young_modulus / (1 + 3 * rock.poisson_ratio);
  return bond;
}

/// Speed of compression waves in a plate, m/s: c^2 = E / (rho (1 - nu^2)) = M_n / (chi rho (1 + nu)) (Kolsky 1963,
/// "Stress Waves in Solids", chapter 3).
inline double wave_speed_of(const BondParameters& bond, double density) {
  return std::sqrt(bond.normal_modulus / (bond.length_factor * density * (1 + elasticity_of(bond).poisson_ratio)));
}

}  // namespace vug
