#pragma once
// The elastic numbers of a bond: those of the rock, or its own where the rock is of several materials.
#include "dem/bonds.hpp"
#include "dem/parameters.hpp"

namespace vug {

/// The rock's numbers with those that the bond has of its own.
KOKKOS_FORCEINLINE_FUNCTION BondParameters own_law(const BondParameters& rock, const BondElasticity& own, int k) {
  BondParameters law = rock;
  law.normal_modulus = own.normal_modulus(k);
  law.tangential_modulus = own.tangential_modulus(k);
  law.internal_friction = own.internal_friction(k);
  law.damping = own.damping(k);
  return law;
}

/// Of bond k, whatever the rock is made of.
KOKKOS_FORCEINLINE_FUNCTION BondParameters law_of(const BondParameters& rock, const BondElasticity& own, int k) {
  return own.given() ? own_law(rock, own, k) : rock;
}

/// For the kernels of a step, which are compiled for either: rock of one material reads nothing.
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
