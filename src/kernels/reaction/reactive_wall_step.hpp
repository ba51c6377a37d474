#pragma once
// The reaction at one link, by either law.
#include "kernels/base/require.hpp"
#include "kernels/reaction/reactive_wall.hpp"

namespace vug {

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
template <class T, class Product>
struct KineticStep {
  T q, y;
  ReactiveLinks<T> links;
  ScalarField<T> h;
  Product product;
  KOKKOS_FUNCTION void operator()(int l) const {
    const int slot = links.slot(l);
    T A2 = 0;
    if constexpr (Product::exists) A2 = product.h(slot);
    const T J = links.conductance(l) * (h(slot) - q * A2);
    h(slot) -= J;
    if constexpr (Product::exists) product.h(slot) = A2 + y * J;
    links.acid(l) += double(J);
  }
};

/// Kinetic law of minerals. Of an order n other than 1 the wall takes C_ref k (C/C_ref)^n: see `converted`.
template <class T, class Set, class Product>
struct MineralStep {
  MineralRates minerals;
  T reference;
  ReactiveLinks<T> links;
  ScalarField<T> h;
  Product product;
  KOKKOS_FORCEINLINE_FUNCTION T flux(const MineralRate& mineral, int l, T A1, T A2) const {
    if (mineral.order == 1) return links.conductance(l) * (A1 - T(mineral.inverse_equilibrium) * A2);
    const T whole = T(Set::w(links.root(l) % 8 + 1)) * reference;  // both directions of a link weigh the same
    return 2 * whole * converted<T>(A1 / whole, 3 * links.conductance(l), T(mineral.order));
  }
  KOKKOS_FUNCTION void operator()(int l) const {
    const int slot = links.slot(l);
    T A2 = 0;
    if constexpr (Product::exists) A2 = product.h(slot);
    const MineralRate& mineral = minerals.rate(links.mineral.extent(0) > 0 ? links.mineral(l) : 0);
    const T J = flux(mineral, l, h(slot), A2);
    h(slot) -= J;
    if constexpr (Product::exists) product.h(slot) = A2 + T(mineral.product_yield) * J;
    links.acid(l) += double(J);
  }
};

/// visit(step): what the kinetic law does at one link.
template <class Set, class T, class Product, class Visit>
void visit_kinetic_step(const ReactiveWall& wall, const ReactiveLinks<T>& links, const ScalarField<T>& h,
                        const Product& product, const Visit& visit) {
  if (wall.minerals.given())
    visit(MineralStep<T, Set, Product>{wall.minerals, T(wall.reference_concentration), links, h, product});
  else
    visit(KineticStep<T, Product>{T(wall.inverse_equilibrium), T(wall.product_yield), links, h, product});
}

/// 1/K_eq and y of a link by the paper's law.
template <class T>
struct SameEquilibrium {
  T q, y;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int) const { return q; }
  KOKKOS_FORCEINLINE_FUNCTION T yield(int) const { return y; }
};
template <class T>
struct MineralEquilibrium {
  Kokkos::View<const MineralRate*> rate;
  Kokkos::View<const std::uint8_t*> mineral;
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int l) const { return T(rate(mineral(l)).inverse_equilibrium); }
  KOKKOS_FORCEINLINE_FUNCTION T yield(int l) const { return T(rate(mineral(l)).product_yield); }
};

/// Paper's law: Eq. 22 from the concentration at the fluid node, Eq. 23 for the populations of all links, Eq. 24 for
/// the solid over the four faces.
template <class T, class Set, class Equilibrium, class Product>
struct PaperStep {
  Equilibrium equilibrium;
  T D1, D2;
  int capacity;
  ReactiveLinks<T> links;
  ScalarField<T> h;
  Kokkos::View<const T*> C;
  Product product;
  KOKKOS_FUNCTION void operator()(int l) const {
    const int slot = links.slot(l), outgoing = Set::opposite(links.root(l) % 8 + 1);
    const int fluid = slot - outgoing * capacity;
    T C2 = 0;
    if constexpr (Product::exists) C2 = product.C(fluid);
    const PaperWall<T> w = paper_wall(links.conductance(l), equilibrium(l), D1, D2, C(fluid), C2, equilibrium.yield(l));
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

/// Throws InputError where a reaction that comes to an equilibrium lacks its product.
inline void require_product(const ReactiveWall& wall, bool has_product) {
  if (!has_product && wall.inverse_equilibrium != 0 && !wall.minerals.given())
    throw InputError("reaction: a finite equilibrium constant needs a product species");
}

}  // namespace vug
