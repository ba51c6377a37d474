#pragma once
// What the fracture energy of bonds makes of the rock: the length over which cracks soften, and what crooked paths add.
#include "dem/elasticity.hpp"

namespace vug {

/// E G_I / sigma_n^2, m: the length over which a crack softens, by order of magnitude (Hillerborg, Modeer and Petersson
/// 1976). Infinite for bonds without strength.
constexpr double softening_length(const BondParameters& bond) {
  return elasticity_of(bond).young_modulus * bond.fracture_energy_I / (bond.normal_strength * bond.normal_strength);
}

/// The default of a case's path_ratio: of the generator's triangles, the same for every seed (docs/validation.md,
/// toughness).
inline constexpr double generated_path_ratio = 1.2;

/// The bonds of a rock whose fracture energies are given: a crack takes path_ratio times more per projected area than
/// its bonds do, since its path is crooked (docs/model.md, toughness).
constexpr BondParameters bonds_of_rock(BondParameters rock, double path_ratio) {
  rock.fracture_energy_I /= path_ratio;
  rock.fracture_energy_II /= path_ratio;
  return rock;
}

}  // namespace vug
