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
  KOKKOS_FORCEINLINE_FUNCTION double drag_before(int, int, int) const { return 0; }
  KOKKOS_FORCEINLINE_FUNCTION void keep_drag(int, int, double, double) const {}
};

/// Sums since the last reset, J per m of thickness.
///
/// The leapfrog moves a body by dt (v- + v+) / 2 round the time t of a force, so a spring of force -k x(t) takes up
/// k x(t) (x(t+dt) - x(t-dt)) / 2, which is exactly the change of k x(t) x(t+dt) / 2: that product is the elastic energy
/// the scheme keeps (k x^2 / 2 is off by (omega dt)^2 / 8 of it, several per cent for the fastest waves of a breaking
/// bond). The losses follow from the same sum: damage dd releases dd k x(t) x(t-dt) / 2, a slider that moves by ds in a
/// spring of stretch e takes k (e(t) + e(t-dt)) ds / 2, and a dashpot half a step of work on either side of its force.
struct Accounts {
  static constexpr bool kept = true;
  /// (bond, 2 point + normal or tangential) dashpot stress of the last step, Pa: its later half is not yet in the sums
  Kokkos::View<double* [4], Kokkos::LayoutLeft> bond_drag;
  ScalarField<double> bond_fracture, bond_friction, bond_damping;  ///< (bond)
  ScalarField<double> pair_friction, pair_damping;                 ///< (lower particle of contact pairs)
  ScalarField<double> particle_work;                               ///< (particle) by loads, fluid, gravity and platens
  ScalarField<double> particle_damping;                            ///< (particle) local damping

  KOKKOS_FORCEINLINE_FUNCTION void add_bond(int k, double fracture, double friction, double damping) const {
    bond_fracture(k) += fracture;
    bond_friction(k) += friction;
    bond_damping(k) += damping;
  }
  KOKKOS_FORCEINLINE_FUNCTION double drag_before(int k, int point, int direction) const {
    return bond_drag(k, 2 * point + direction);
  }
  KOKKOS_FORCEINLINE_FUNCTION void keep_drag(int k, int point, double normal, double tangential) const {
    bond_drag(k, 2 * point) = normal;
    bond_drag(k, 2 * point + 1) = tangential;
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
