#pragma once
// The reaction at one link, by either law.
#include "kernels/base/require.hpp"
#include "kernels/reaction/rock_of_links.hpp"

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
