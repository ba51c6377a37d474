#pragma once
// Effect of the fracture energy of bonds on the rock: the length over which cracks soften, and what crooked paths add.
#include "dem/elasticity.hpp"

namespace vug {

/// E G_I / sigma_n^2, m: order of magnitude of the length over which a crack softens (Hillerborg, Modeer and Petersson
/// 1976). Infinite for bonds without strength.
constexpr double softening_length(const BondParameters& bond) {
  return elasticity_of(bond).young_modulus * bond.fracture_energy_I / (bond.normal_strength * bond.normal_strength);
}

/// Default of a case's path_ratio: that of the generator's triangles, the same for every seed (docs/validation.md,
/// toughness).
inline constexpr double generated_path_ratio = 1.2;

/// Bonds of a rock whose fracture energies are given. A crack takes path_ratio times more per projected area than its
/// bonds do, because its path is crooked (docs/model.md, toughness).
constexpr BondParameters bonds_of_rock(BondParameters rock, double path_ratio) {
  rock.fracture_energy_I /= path_ratio;
  rock.fracture_energy_II /= path_ratio;
  return rock;
}

}  // namespace vug
