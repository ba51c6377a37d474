#pragma once
// Parameters of a bond: those of the rock, or its own where the rock is of several materials.
#include "dem/bonds.hpp"
#include "dem/parameters.hpp"

namespace vug {

/// Parameters of bond k: those of the rock, with the numbers that the bond has of its own.
KOKKOS_FORCEINLINE_FUNCTION BondParameters own_law(const BondParameters& rock, const BondElasticity& own, int k) {
  BondParameters law = rock;
  law.normal_modulus = own.normal_modulus(k);
  law.tangential_modulus = own.tangential_modulus(k);
  law.internal_friction = own.internal_friction(k);
  law.damping = own.damping(k);
  return law;
}

/// Parameters of bond k, for rock of one material or of several.
KOKKOS_FORCEINLINE_FUNCTION BondParameters law_of(const BondParameters& rock, const BondElasticity& own, int k) {
  return own.given() ? own_law(rock, own, k) : rock;
}

/// Parameters of the bonds of rock of one material; LawOfEach: of several. The kernels of a step are compiled for both,
/// so that the first reads nothing per bond.
struct OneLaw {
  BondParameters rock;
  KOKKOS_FORCEINLINE_FUNCTION const BondParameters& of(int) const { return rock; }
};
struct LawOfEach {
  BondParameters rock;
  BondElasticity own;
  KOKKOS_FORCEINLINE_FUNCTION BondParameters of(int k) const { return own_law(rock, own, k); }
};

}  // namespace vug
