// Finds the links through which walls react.
#include "kernels/launch/launch.hpp"
#include "kernels/reaction/reactive_wall.hpp"

namespace vug {

/// Velocities of Set without that at rest, as bits of the link masks of FluidNodes.
template <class Set>
inline constexpr unsigned moving = (1u << Set::Q) - 2;

/// Counts the links of a fluid node into first(i + 1).
template <class Set>
struct CountLinksOfFluid {
  Kokkos::View<const std::uint16_t*> solid_links;
  IndexList first;
  KOKKOS_FUNCTION void operator()(int i) const { first(i + 1) = Kokkos::popcount(solid_links(i) & moving<Set>); }
};

/// Lists the links of a surface node, or with fill = false counts them into of_surface(s + 1).
template <class T, class Set>
struct ListReactiveLinks {
  DenseNeighbour lattice;
  IndexList node, index;
  Kokkos::View<const std::uint16_t*> solid_links;
  int capacity;
  ReactiveLinks<T> links;
  bool fill;

  KOKKOS_FUNCTION void operator()(int s) const {
    int at = fill ? links.of_surface(s) : 0;
    for (int q = 1; q < Set::Q; ++q) {
      const int fluid = lattice.fluid_along(index, node(s), q);
      if (fluid < 0) continue;
      if (fill) links.of_surface_link(at) = list(s, q, fluid);
      ++at;
    }
    if (!fill) links.of_surface(s + 1) = at;
  }

 private:
  /// The link between surface node s and the fluid node along q.
  KOKKOS_FUNCTION int list(int s, int q, int fluid) const {
    const int outgoing = Set::opposite(q);
    const unsigned before = solid_links(fluid) & moving<Set> & ((1u << outgoing) - 1);
    const int link = links.first(fluid) + Kokkos::popcount(before);
    links.slot(link) = outgoing * capacity + fluid;
    links.root(link) = 8 * s + q - 1;
    return link;
  }
};

/// Stores the mineral of the surface node of a link.
template <class T>
struct MineralOfLink {
  ReactiveLinks<T> links;
  IndexList node;
  Kokkos::View<const std::uint8_t*> of_node;
  KOKKOS_FUNCTION void operator()(int l) const { links.mineral(l) = of_node(node(links.surface_of(l))); }
};

namespace {

template <class T>
void make_room(ReactiveLinks<T>& links, ReactiveWallLaw law, bool minerals) {
  if (static_cast<int>(links.slot.extent(0)) >= links.count) return;
  const std::size_t room = links.count + links.count / 2;
  links.of_surface_link = IndexList("vug::reactive_wall::of_surface_link", room);
  links.slot = IndexList("vug::reactive_wall::slot", room);
  links.root = IndexList("vug::reactive_wall::root", room);
  links.rate = ScalarField<T>("vug::reactive_wall::rate", room);
  links.conductance = ScalarField<T>("vug::reactive_wall::conductance", room);
  if (minerals) links.mineral = Kokkos::View<std::uint8_t*>("vug::reactive_wall::mineral", room);
  links.acid = links.product = links.solid = ScalarField<double>("vug::reactive_wall::acid", room);
  if (law == ReactiveWallLaw::kinetic) return;
  links.product = ScalarField<double>("vug::reactive_wall::product", room);
  links.solid = ScalarField<double>("vug::reactive_wall::solid", room);
}

/// Runs `count` for n items, which stores counts in offset(1 .. n), and turns these into offsets; returns the total.
template <class Count>
int places(const Exec& exec, const char* label, int n, const Count& count, const IndexList& offset) {
  for_each_node(exec, label, n, count);
  return accumulate_counts(exec, "vug::reactive_wall::places", Kokkos::subview(offset, std::pair(0, n + 1)));
}

IndexList fitting(const char* label, const IndexList& list, int n) {
  return static_cast<int>(list.extent(0)) < n + 1 ? IndexList(label, n + n / 2 + 1) : list;
}

}  // namespace

template <class Set, class T>
void find_reactive_links(const Exec& exec, const FluidNodes& nodes, const Surface& surface, ReactiveWallLaw law,
                         ReactiveLinks<T>& links, const Kokkos::View<const std::uint8_t*>& mineral) {
  links.first = fitting("vug::reactive_wall::first", links.first, nodes.count);
  links.of_surface = fitting("vug::reactive_wall::of_surface", links.of_surface, surface.count);
  links.count = places(exec, "vug::reactive_wall::count", nodes.count,
                       CountLinksOfFluid<Set>{nodes.solid_links, links.first}, links.first);
  make_room(links, law, mineral.extent(0) > 0);
  Kokkos::deep_copy(exec, links.rate, T(0));  // no values of former lists are left in unused entries
  Kokkos::deep_copy(exec, links.conductance, T(0));
  ListReactiveLinks<T, Set> list{nodes.around(), surface.node, nodes.index, nodes.solid_links,
                                 nodes.capacity, links,        false};
  places(exec, "vug::reactive_wall::count_of_surface", surface.count, list, links.of_surface);
  list.fill = true;
  for_each_node(exec, "vug::reactive_wall::list", surface.count, list);
  if (mineral.extent(0) > 0)
    for_each_node(exec, "vug::reactive_wall::mineral_of_link", links.count,
                  MineralOfLink<T>{links, surface.node, mineral});
}

VUG_COMPILE_FOR_SETS(find_reactive_links)

}  // namespace vug
