#pragma once
// Equilibrium distribution over the velocities of a scalar that the fluid carries.
#include "kernels/base/velocity_set.hpp"

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

}  // namespace vug
