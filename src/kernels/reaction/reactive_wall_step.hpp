#pragma once
// The reaction at one link, by either law.
#include "base/require.hpp"
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

/// Product policies.
struct NoProduct {
  static constexpr bool exists = false;
};
template <class T>
struct WithProduct {
  static constexpr bool exists = true;
  ScalarField<T> h;
  Kokkos::View<const T*> C;
};

/// Kinetic law: J from both outgoing populations, A1 - J and A2 + y J return.
template <class T, class Rock, class Product>
struct KineticStep {
  Rock rock;
  ReactiveLinks<T> links;
  ScalarField<T> h;
  Product product;
  Rounding<T> rounding;
  KOKKOS_FUNCTION void operator()(int l) const {
    const int slot = links.slot(l);
    T A2 = 0;
    if constexpr (Product::exists) A2 = product.h(slot);
    const T J = rock.flux(links, l, h(slot), A2);
    h(slot) = rounding.sum(h(slot), -J, l);
    if constexpr (Product::exists) product.h(slot) = rounding.sum(A2, rock.yield(links, l) * J, l);
    links.acid(l) += double(J);
  }
};

/// Paper's law: Eq. 22 from the concentration at the fluid node, Eq. 23 for the populations of all links, Eq. 24 for
/// the solid over the four faces.
template <class T, class Set, class Rock, class Product>
struct PaperStep {
  Rock rock;
  T D1, D2;
  int capacity;
  ReactiveLinks<T> links;
  ScalarField<T> h;
  Kokkos::View<const T*> C;
  Product product;
  KOKKOS_FUNCTION void operator()(int l) const {
    const int slot = links.slot(l), outgoing = Set::opposite(links.direction_of(l));
    const int fluid = slot - outgoing * capacity;
    T C2 = 0;
    if constexpr (Product::exists) C2 = product.C(fluid);
    const PaperWall<T> w =
        paper_wall(links.conductance(l), rock.equilibrium(links, l), D1, D2, C(fluid), C2, rock.yield(links, l));
    const T weight = T(Set::w(outgoing));
    const T A1 = h(slot);
    h(slot) = 2 * weight * w.C1 - A1;
    links.acid(l) += double(A1) - double(h(slot));
    if constexpr (Product::exists) {
      const T A2 = product.h(slot);
      product.h(slot) = 2 * weight * w.C2 - A2;
      links.product(l) += double(product.h(slot)) - double(A2);
    }
    if (outgoing < D2Q5::Q) links.solid(l) += double(w.rate);
  }
};

/// Throws InputError where a reaction with a finite equilibrium constant lacks its product.
inline void require_product(const ReactiveWall& wall, bool has_product) {
  if (!has_product && wall.inverse_equilibrium != 0 && !wall.minerals.given())
    throw InputError("reaction: a finite equilibrium constant needs a product species");
}

}  // namespace vug
