#pragma once
// The material of the wall at a link: policies of the kernels at a reactive wall.
#include "kernels/reaction/reactive_wall.hpp"

namespace vug {

/// Rock of one kind, of first order: 1/K_eq and y of all links, and the flux J from both outgoing populations by the
/// kinetic law.
template <class T>
struct OneRock {
  T q, y;
  KOKKOS_FORCEINLINE_FUNCTION bool first_order(const ReactiveLinks<T>&, int) const { return true; }
  KOKKOS_FORCEINLINE_FUNCTION T equilibrium(const ReactiveLinks<T>&, int) const { return q; }
  KOKKOS_FORCEINLINE_FUNCTION T yield(const ReactiveLinks<T>&, int) const { return y; }
  KOKKOS_FORCEINLINE_FUNCTION T flux(const ReactiveLinks<T>& links, int l, T A1, T A2) const {
    return links.conductance(l) * (A1 - q * A2);
  }
};

/// Minerals. For an order n other than 1 the rate at the wall is C_ref k (C/C_ref)^n: see `converted`.
template <class T, class Set>
struct RockOfMinerals {
  Kokkos::View<const MineralRate*> rate;  ///< (mineral)
  T reference;                            ///< C_ref
  KOKKOS_FORCEINLINE_FUNCTION const MineralRate& at(const ReactiveLinks<T>& links, int l) const {
    return rate(links.mineral.extent(0) > 0 ? links.mineral(l) : 0);
  }
  KOKKOS_FORCEINLINE_FUNCTION bool first_order(const ReactiveLinks<T>& links, int l) const {
    return at(links, l).order == 1;
  }
  KOKKOS_FORCEINLINE_FUNCTION T equilibrium(const ReactiveLinks<T>& links, int l) const {
    return T(at(links, l).inverse_equilibrium);
  }
  KOKKOS_FORCEINLINE_FUNCTION T yield(const ReactiveLinks<T>& links, int l) const {
    return T(at(links, l).product_yield);
  }
  KOKKOS_FORCEINLINE_FUNCTION T flux(const ReactiveLinks<T>& links, int l, T A1, T A2) const {
    const MineralRate& mineral = at(links, l);
    if (mineral.order == 1) return links.conductance(l) * (A1 - T(mineral.inverse_equilibrium) * A2);
    const T whole = T(Set::w(links.direction_of(l))) * reference;  // both directions of a link weigh the same
    return 2 * whole * converted<T>(A1 / whole, 3 * links.conductance(l), T(mineral.order));
  }
};

/// Calls visit(rock) with the material of `wall`.
template <class T, class Set, class Visit>
void visit_rock(const ReactiveWall& wall, const Visit& visit) {
  if (wall.minerals.given())
    visit(RockOfMinerals<T, Set>{wall.minerals.rate, T(wall.reference_concentration)});
  else
    visit(OneRock<T>{T(wall.inverse_equilibrium), T(wall.product_yield)});
}

}  // namespace vug
