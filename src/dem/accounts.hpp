#pragma once
// Accounts of the energy that a step spends, kept per item by the kernels that spend it. `NoAccounts` is the default
// and costs nothing.
#include "base/base.hpp"

namespace vug {

/// Keeps nothing.
struct NoAccounts {
  static constexpr bool kept = false;
  KOKKOS_FORCEINLINE_FUNCTION void add_bond(int, double, double, double) const {}
  KOKKOS_FORCEINLINE_FUNCTION void add_pair_friction(int, double) const {}
  KOKKOS_FORCEINLINE_FUNCTION void add_particle(int, double, double) const {}
  KOKKOS_FORCEINLINE_FUNCTION double drag_before(int, int, int) const { return 0; }
  KOKKOS_FORCEINLINE_FUNCTION void keep_drag(int, int, double, double) const {}
  KOKKOS_FORCEINLINE_FUNCTION void keep_pair_drag(int, double, double, double, double) const {}
};

/// Sums since the last reset, J per m of thickness.
///
/// In the leapfrog a force at time t acts between the velocities v- and v+ half a step before and after, over the path
/// dt (v- + v+) / 2. A spring of force -k x(t) therefore takes up k x(t) (x(t+dt) - x(t-dt)) / 2, which is exactly the
/// change of k x(t) x(t+dt) / 2. This product is the elastic energy that the scheme keeps; k x^2 / 2 differs from it by
/// the fraction (omega dt)^2 / 8, several per cent for the fastest waves of a breaking bond. The losses follow from the
/// same sum:
/// - damage dd releases dd k x(t) x(t-dt) / 2;
/// - a slider that moves by ds in a spring of stretch e takes k (e(t) + e(t-dt)) ds / 2;
/// - a dashpot takes half a step of work on either side of its force. The dashpots of contacts are booked by the
///   integrator, which knows both velocities.
struct Accounts {
  static constexpr bool kept = true;
  /// (bond, 2 * point + (0: normal, 1: tangential)) dashpot stress of the last step, Pa; the second half of its work is
  /// not yet in the sums
  Kokkos::View<double* [4], Kokkos::LayoutLeft> bond_drag;
  ScalarField<double> bond_fracture, bond_friction, bond_damping;  ///< (bond)
  ScalarField<double> pair_friction;                               ///< (lower particle of contact pairs)
  /// (pair, component) part of Contacts::load that the dashpots cause, and (particle, component) that of Contacts::push
  Kokkos::View<double* [4], Kokkos::LayoutLeft> pair_drag;
  Kokkos::View<double* [3], Kokkos::LayoutLeft> particle_drag;
  ScalarField<double> particle_work;     ///< (particle) by loads, fluid, gravity and platens
  ScalarField<double> particle_damping;  ///< (particle) local damping, dashpots of contacts

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
  KOKKOS_FORCEINLINE_FUNCTION void add_pair_friction(int i, double friction) const { pair_friction(i) += friction; }
  KOKKOS_FORCEINLINE_FUNCTION void keep_pair_drag(int pair, double x, double y, double torque_low,
                                                  double torque_high) const {
    pair_drag(pair, 0) = x;
    pair_drag(pair, 1) = y;
    pair_drag(pair, 2) = torque_low;
    pair_drag(pair, 3) = torque_high;
  }
  KOKKOS_FORCEINLINE_FUNCTION void add_particle(int i, double work, double damping) const {
    particle_work(i) += work;
    particle_damping(i) += damping;
  }
};

}  // namespace vug
