#pragma once
// Equilibrium distribution over the velocities of a scalar that the fluid carries.
#include "base/base.hpp"
#include "base/velocity_set.hpp"

#include <type_traits>

namespace vug {

/// h_i^eq / (w_i C) for fluid velocity (ux, uy) in lattice units: the paper's quadratic form (Eq. 15 without the
/// gradient term) on D2Q9, the linear form on D2Q5, whose five velocities carry no second-order term. V is T or a pack
/// of such numbers.
template <class Set, class T, class V>
KOKKOS_FORCEINLINE_FUNCTION V scalar_equilibrium(int q, const V& ux, const V& uy) {
  const V cu = along(q, ux, uy);
  if constexpr (std::is_same_v<Set, D2Q9>)
    return T(1) + T(3) * cu + T(4.5) * cu * cu - T(1.5) * (ux * ux + uy * uy);
  else
    return T(1) + T(3) * cu;
}

/// The part of it on D2Q9 that does not change sign with the velocity, without the one: 9/2 (c_q.u)^2 - 3/2 u^2.
template <class T, class V>
KOKKOS_FORCEINLINE_FUNCTION V scalar_even_part(int q, const V& ux, const V& uy) {
  const V cu = along(q, ux, uy);
  return T(4.5) * cu * cu - T(1.5) * (ux * ux + uy * uy);
}

/// How far the fluid moves in one step of a scalar that takes `steps` flow steps: steps times the velocity u (fluid,
/// axis) of the latest of them. A plain velocity converts to the displacement of one flow step.
template <class T>
struct Displacement {
  Kokkos::View<const T* [2], Kokkos::LayoutLeft> u;
  T steps = 1;

  Displacement(const VectorField<T>& velocity, int flow_steps = 1) : u(velocity), steps(static_cast<T>(flow_steps)) {}
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int i, int axis) const { return steps * u(i, axis); }
};

/// The links through which fluid crosses a boundary and the displacement of the fluid in a step of the scalar. By
/// default it crosses nowhere.
template <class T>
struct Crossing {
  Kokkos::View<const std::uint16_t*> open_links{};  ///< (fluid) as of FluidNodes
  Displacement<T> u{VectorField<T>()};

  /// Sum of the populations that go out and come in through link q of fluid node i at equilibrium, over 2 w C: one at
  /// rest and on D2Q5. On D2Q9 it has the even part of the equilibrium, without which fluid that flows in has that much
  /// less of the scalar than the boundary.
  template <class Set>
  KOKKOS_FORCEINLINE_FUNCTION T pair(int i, int q) const {
    if constexpr (Set::Q == D2Q5::Q) {
      return T(1);
    } else {
      if (open_links.extent(0) == 0 || !(open_links(i) >> q & 1)) return T(1);
      return T(1) + scalar_even_part<T>(q, u(i, 0), u(i, 1));
    }
  }
};

}  // namespace vug
