#pragma once
// Where energy goes in a step, kept per item by the kernels that spend it. `NoAccounts` is the default and costs
// nothing.
#include "kernels/base.hpp"

namespace vug {

/// Nothing is kept.
struct NoAccounts {
  static constexpr bool kept = false;
  KOKKOS_FORCEINLINE_FUNCTION void add_bond(int, double, double, double) const {}
  KOKKOS_FORCEINLINE_FUNCTION void add_pair(int, double, double) const {}
  KOKKOS_FORCEINLINE_FUNCTION void add_particle(int, double, double) const {}
};

/// Sums since the last reset, J per m of thickness.
struct Accounts {
  static constexpr bool kept = true;
  ScalarField<double> bond_fracture, bond_friction, bond_damping;  ///< (bond)
  ScalarField<double> pair_friction, pair_damping;                 ///< (lower particle of contact pairs)
  ScalarField<double> particle_work;                               ///< (particle) by loads, fluid, gravity and platens
  ScalarField<double> particle_damping;                            ///< (particle) local damping

  KOKKOS_FORCEINLINE_FUNCTION void add_bond(int k, double fracture, double friction, double damping) const {
    bond_fracture(k) += fracture;
    bond_friction(k) += friction;
    bond_damping(k) += damping;
  }
  KOKKOS_FORCEINLINE_FUNCTION void add_pair(int i, double friction, double damping) const {
    pair_friction(i) += friction;
    pair_damping(i) += damping;
  }
  KOKKOS_FORCEINLINE_FUNCTION void add_particle(int i, double work, double damping) const {
    particle_work(i) += work;
    particle_damping(i) += damping;
  }
};

}  // namespace vug
