#include "kernels/reactive_wall_kernel.hpp"

#include "kernels/dense_neighbour.hpp"
#include "kernels/offsets.hpp"
#include "kernels/prefetch.hpp"
#include "kernels/require.hpp"

namespace vug {

/// Counts (fill = false, into first(s + 1)) or lists the links of a surface node.
template <class T, class Set>
struct ListReactiveLinks {
  DenseNeighbour lattice;
  IndexList node, index;
  int capacity;
  ReactiveLinks<T> links;
  bool fill;
  KOKKOS_FUNCTION void operator()(int s) const {
    int at = fill ? links.first(s) : 0;
    for (int q = 1; q < Set::Q; ++q) {
      const int fluid = lattice.fluid_along(index, node(s), q);
      if (fluid < 0) continue;
      if (fill) {
        links.slot(at) = Set::opposite(q) * capacity + fluid;
        links.root(at) = 8 * s + q - 1;
      }
      ++at;
    }
    if (!fill) links.first(s + 1) = at;
  }
};

namespace {

template <class T>
void make_room(ReactiveLinks<T>& links, ReactiveWallLaw law) {
  if (static_cast<int>(links.slot.extent(0)) >= links.count) return;
  const std::size_t room = links.count + links.count / 2;
  links.slot = IndexList("vug::reactive_wall::slot", room);
  links.root = IndexList("vug::reactive_wall::root", room);
  links.rate = ScalarField<T>("vug::reactive_wall::rate", room);
  links.conductance = ScalarField<T>("vug::reactive_wall::conductance", room);
  links.acid = links.product = links.solid = ScalarField<double>("vug::reactive_wall::acid", room);
  if (law == ReactiveWallLaw::kinetic) return;
  links.product = ScalarField<double>("vug::reactive_wall::product", room);
  links.solid = ScalarField<double>("vug::reactive_wall::solid", room);
}

}  // namespace

template <class Set, class T>
void find_reactive_links(const Exec& exec, const FluidNodes& nodes, const Surface& surface, ReactiveWallLaw law,
                         ReactiveLinks<T>& links) {
  if (static_cast<int>(links.first.extent(0)) < surface.count + 1)
    links.first = IndexList("vug::reactive_wall::first", surface.count + surface.count / 2 + 1);
  ListReactiveLinks<T, Set> list{DenseNeighbour(nodes), surface.node, nodes.index, nodes.capacity, links, false};
  for_each_node(exec, "vug::reactive_wall::count", surface.count, list);
  links.count = accumulate_counts(exec, "vug::reactive_wall::places",
                                  Kokkos::subview(links.first, std::pair(0, surface.count + 1)));
  make_room(links, law);
  list.links = links;
  list.fill = true;
  for_each_node(exec, "vug::reactive_wall::list", surface.count, list);
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

/// Kinetic law: J from both outgoing populations, A1 - J and A2 + J return.
template <class T, class Product>
struct KineticStep {
  T q;
  ReactiveLinks<T> links;
  ScalarField<T> h;
  Product product;
  KOKKOS_FUNCTION void operator()(int l) const {
    const int slot = links.slot(l);
    T A2 = 0;
    if constexpr (Product::exists) A2 = product.h(slot);
    const T J = links.conductance(l) * (h(slot) - q * A2);
    h(slot) -= J;
    if constexpr (Product::exists) product.h(slot) = A2 + J;
    links.acid(l) += double(J);
  }
};

/// Paper's law: Eq. 22 from the concentration at the fluid node, Eq. 23 for the populations of all links, Eq. 24 for
/// the solid over the four faces.
template <class T, class Set, class Product>
struct PaperStep {
  T q, D1, D2;
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
    const PaperWall<T> w = paper_wall(links.conductance(l), q, D1, D2, C(fluid), C2);
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

template <class Set, class T>
void react_at_wall(const Exec& exec, const FluidNodes& nodes, const ReactiveWall& wall, const ReactiveLinks<T>& links,
                   const SoluteFields<T>& reactant, const SoluteFields<T>* product) {
  if (!product && wall.inverse_equilibrium != 0)
    throw InputError("reaction: a finite equilibrium constant needs a product species");
  const T q = T(wall.inverse_equilibrium);
  const auto launch = [&](const auto& its_product) {
    using Product = std::decay_t<decltype(its_product)>;
    const char* label = "vug::reactive_wall::react";
    if (wall.law == ReactiveWallLaw::kinetic)
      for_each_scattered(exec, label, links.count, KineticStep<T, Product>{q, links, reactant.h, its_product});
    else
      for_each_node(exec, label, links.count,
                    PaperStep<T, Set, Product>{q, T(wall.D_reactant), T(wall.D_product), nodes.capacity, links,
                                               reactant.h, reactant.C, its_product});
  };
  if (product)
    launch(WithProduct<T>{product->h, product->C});
  else
    launch(NoProduct{});
}

/// Books the links of one surface node in their order; returns the acid that they consumed.
template <class T>
struct BookTurnover {
  IndexList node;
  int count;
  ReactiveLinks<T> links;
  bool apart;  ///< acid, product and solid are three
  double molar_volume;
  ReactionLedger ledger;

  KOKKOS_FORCEINLINE_FUNCTION static double take(double& amount) {
    const double taken = amount;
    amount = 0;
    return taken;
  }
  /// Surface nodes lie scattered over the lattice.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int s) const {
    constexpr int ahead = 32;
    const int later = node(s + ahead < count ? s + ahead : count - 1);
    prefetch(&ledger.V(later));
    prefetch(&ledger.dissolved(later));
  }
  KOKKOS_FUNCTION double operator()(int s) const {
    announce(s);
    double acid = 0, product = 0, solid = 0;
    for (int l = links.first(s); l < links.first(s + 1); ++l) {
      acid += take(links.acid(l));
      if (!apart) continue;
      product += take(links.product(l));
      solid += take(links.solid(l));
    }
    const int n = node(s);
    const double volume = molar_volume * (apart ? solid : acid);
    ledger.V(n) -= volume;
    ledger.dissolved(n) += volume;
    if (ledger.released.extent(0) > 0) ledger.released(n) += apart ? product : acid;
    return acid;
  }
};

template <class T>
void book_turnover(const Exec& exec, const Surface& surface, const ReactiveWall& wall, const ReactiveLinks<T>& links,
                   const ReactionLedger& ledger) {
  const bool apart = wall.law != ReactiveWallLaw::kinetic;
  add_per_block(exec, "vug::reactive_wall::book", surface.count,
                BookTurnover<T>{surface.node, surface.count, links, apart, wall.molar_volume, ledger}, ledger.consumed);
}

#define VUG_INSTANTIATE(T, Set)                                                                                      \
  template void find_reactive_links<Set, T>(const Exec&, const FluidNodes&, const Surface&, ReactiveWallLaw,         \
                                            ReactiveLinks<T>&);                                                      \
  template void set_conductances<Set, T, UniformRate>(const Exec&, const FluidNodes&, const Surface&,                \
                                                      const ReactiveWall&, const UniformRate&,                       \
                                                      const VectorField<double>&, const ReactiveLinks<T>&, double);  \
  template void react_at_wall<Set, T>(const Exec&, const FluidNodes&, const ReactiveWall&, const ReactiveLinks<T>&, \
                                      const SoluteFields<T>&, const SoluteFields<T>*);
VUG_INSTANTIATE(float, D2Q5)
VUG_INSTANTIATE(double, D2Q5)
VUG_INSTANTIATE(float, D2Q9)
VUG_INSTANTIATE(double, D2Q9)
#undef VUG_INSTANTIATE

template void book_turnover(const Exec&, const Surface&, const ReactiveWall&, const ReactiveLinks<float>&,
                            const ReactionLedger&);
template void book_turnover(const Exec&, const Surface&, const ReactiveWall&, const ReactiveLinks<double>&,
                            const ReactionLedger&);

}  // namespace vug
