#pragma once
// The kernel behind react_at_wall, for whoever brings a rate policy of their own.
#include "kernels/dense_neighbour.hpp"
#include "kernels/launch.hpp"
#include "kernels/reactive_wall.hpp"
#include "kernels/require.hpp"
#include "kernels/unroll.hpp"

namespace vug {

/// What one link did in one step: moles out of the acid, into the product, and off the solid.
struct LinkTurnover {
  double acid = 0, product = 0, solid = 0;
};

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

/// Kinetic law: J from both outgoing populations, A1 - J and A2 + J return.
template <class T, class Product>
struct KineticLink {
  T q;
  ScalarField<T> h;
  Product product;
  KOKKOS_FORCEINLINE_FUNCTION LinkTurnover react(int, int slot, int, double, double rate) const {
    T A2 = 0;
    if constexpr (Product::exists) A2 = product.h(slot);
    const T J = kinetic_flux(T(rate), q, h(slot), A2);
    h(slot) -= J;
    if constexpr (Product::exists) product.h(slot) = A2 + J;
    return {double(J), double(J), double(J)};
  }
};

/// Paper's law: Eq. 22 from the concentration at the fluid node, Eq. 23 for the populations of all links, Eq. 24 for
/// the solid over the four faces.
template <class T, class Product>
struct PaperLink {
  T q, D1, D2;
  ScalarField<T> h;
  Kokkos::View<const T*> C;
  Product product;
  KOKKOS_FORCEINLINE_FUNCTION LinkTurnover react(int fluid, int slot, int direction, double weight, double rate) const {
    T C2 = 0;
    if constexpr (Product::exists) C2 = product.C(fluid);
    const PaperWall<T> w = paper_wall(T(rate), q, D1, D2, C(fluid), C2);
    LinkTurnover t;
    const T A1 = h(slot);
    h(slot) = T(2 * weight) * w.C1 - A1;
    t.acid = double(A1) - double(h(slot));
    if constexpr (Product::exists) {
      const T A2 = product.h(slot);
      product.h(slot) = T(2 * weight) * w.C2 - A2;
      t.product = double(product.h(slot)) - double(A2);
    }
    t.solid = direction < 5 ? double(w.rate) : 0;
    return t;
  }
};

/// Reaction of one surface node with the fluid around it, link by link in the order of the directions.
/// V loses M sum(J), `dissolved` gains it; returns the acid consumed. Conserves acid + product exactly, and acid +
/// V/M with the kinetic law. Per link: 2 s of populations (4 s with product), 4 bytes of index; per node 32 of V.
template <class Set, class Link, class Rate, class Area>
struct ReactAtWall {
  DenseNeighbour lattice;
  IndexList node, index, fluid_node;
  int capacity;
  Link link;
  Rate rate;
  Area area;
  double molar_volume;
  ReactionLedger ledger;

  KOKKOS_FUNCTION double operator()(int s) const {
    const int solid = node(s);
    LinkTurnover sum;
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const int fluid = lattice.fluid_along(index, solid, q);
      if (fluid < 0) continue;
      const int outgoing = Set::opposite(q);
      const LinkTurnover t = link.react(fluid, outgoing * capacity + fluid, outgoing, Set::w(q),
                                        rate(solid, fluid_node(fluid)) * area.share(s, q));
      sum.acid += t.acid;
      sum.product += t.product;
      sum.solid += t.solid;
    }
    ledger.V(solid) -= molar_volume * sum.solid;
    ledger.dissolved(solid) += molar_volume * sum.solid;
    if (ledger.released.extent(0) > 0) ledger.released(solid) += sum.product;
    return sum.acid;
  }
};

template <class Set, class T, class Rate, class Product>
void react_at_wall_with(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ReactiveWall& wall,
                        const Rate& rate, const VectorField<double>& normal, const SoluteFields<T>& reactant,
                        const Product& product, const ReactionLedger& ledger) {
  const auto launch = [&](const auto& link, const auto& area) {
    using Kernel = ReactAtWall<Set, std::decay_t<decltype(link)>, Rate, std::decay_t<decltype(area)>>;
    add_per_block(exec, "vug::reactive_wall::react", surface.count,
                  Kernel{DenseNeighbour(nodes), surface.node, nodes.index, nodes.node, nodes.capacity, link, rate, area,
                         wall.molar_volume, ledger},
                  ledger.consumed);
  };
  with_link_area(normal, [&](const auto& area) {
    const T q = T(wall.inverse_equilibrium);
    if (wall.law == ReactiveWallLaw::kinetic)
      launch(KineticLink<T, Product>{q, reactant.h, product}, area);
    else
      launch(PaperLink<T, Product>{q, T(wall.D_reactant), T(wall.D_product), reactant.h, reactant.C, product}, area);
  });
}

template <class Set, class T, class Rate>
void react_at_wall(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ReactiveWall& wall,
                   const Rate& rate, const VectorField<double>& normal, const SoluteFields<T>& reactant,
                   const SoluteFields<T>* product, const ReactionLedger& ledger) {
  if (product)
    react_at_wall_with<Set, T>(exec, nodes, surface, wall, rate, normal, reactant,
                               WithProduct<T>{product->h, product->C}, ledger);
  else if (wall.inverse_equilibrium == 0)
    react_at_wall_with<Set, T>(exec, nodes, surface, wall, rate, normal, reactant, NoProduct{}, ledger);
  else
    throw InputError("reaction: a finite equilibrium constant needs a product species");
}

/// Mean of the rate over the links of one surface node.
template <class Rate>
struct StoreRate {
  DenseNeighbour lattice;
  IndexList node, index, fluid_node;
  Rate rate;
  ScalarField<double> k;
  KOKKOS_FUNCTION void operator()(int s) const {
    const int solid = node(s);
    double sum = 0;
    int links = 0;
    for (int q = 1; q < D2Q9::Q; ++q) {
      if (q == D2Q5::Q && links > 0) break;
      const int fluid = lattice.fluid_along(index, solid, q);
      if (fluid < 0) continue;
      sum += rate(solid, fluid_node(fluid));
      ++links;
    }
    if (links > 0) k(solid) = sum / links;
  }
};

template <class Rate>
void store_rates(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const Rate& rate,
                 const ScalarField<double>& k) {
  for_each_node(exec, "vug::reactive_wall::store_rates", surface.count,
                StoreRate<Rate>{DenseNeighbour(nodes), surface.node, nodes.index, nodes.node, rate, k});
}

}  // namespace vug
