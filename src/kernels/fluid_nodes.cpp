#include "kernels/fluid_nodes.hpp"

#include "kernels/dense_neighbour.hpp"
#include "kernels/launch.hpp"

namespace vug {

namespace {

constexpr int Q = D2Q9::Q;
static_assert(Q - 1 == nodes_per_window, "as many windows as nodes");

int round_capacity(int count) {
  return (count + 15) / 16 * 16;
}

}  // namespace

/// Numbers the fluid nodes that have no number yet, in order of node, from `first` on.
struct NumberFluid {
  Lattice lattice;
  Kokkos::View<const NodeType*> type;
  IndexList node, index;
  int first;
  KOKKOS_FUNCTION void operator()(int item, int& running, bool last) const {
    const int n = interior_node(lattice, item);
    if (type(n) != NodeType::fluid || index(n) >= 0) return;
    if (last) {
      node(first + running) = n;
      index(n) = first + running;
    }
    ++running;
  }
};

struct CountUnnumbered {
  Lattice lattice;
  Kokkos::View<const NodeType*> type;
  IndexList index;
  KOKKOS_FUNCTION void operator()(int item, int& count) const {
    const int n = interior_node(lattice, item);
    if (type(n) == NodeType::fluid && index(n) < 0) ++count;
  }
};

/// Bakes the walls into the table of sources and notes what lies beyond every link of one fluid node.
struct BuildLinks {
  Lattice lattice;
  bool periodic_x, periodic_y;
  int capacity;
  IndexList node, index, source;
  Kokkos::View<std::uint16_t*> solid_links, side_links, open_links;
  KOKKOS_FUNCTION void operator()(int i) const {
    unsigned solid = 0, side = 0;
    source(i) = i;
    for (int q = 1; q < Q; ++q) {
      const int opposite = D2Q9::opposite(q);
      const int beyond = neighbour(lattice, periodic_x, periodic_y, node(i), q);
      const int upstream = neighbour(lattice, periodic_x, periodic_y, node(i), opposite);
      if (beyond < 0 || index(beyond) == in_opening)
        side |= 1u << q;
      else if (index(beyond) < 0)
        solid |= 1u << q;
      const bool flows = upstream >= 0 && index(upstream) >= 0;
      source(q * capacity + i) = flows ? q * capacity + index(upstream) : opposite * capacity + i;
    }
    solid_links(i) = static_cast<std::uint16_t>(solid);
    side_links(i) = static_cast<std::uint16_t>(side);
    open_links(i) = 0;
  }
};

/// The windows of eight nodes in all directions.
struct BuildWindows {
  int capacity;
  IndexList source;
  Kokkos::View<SourceWindow*> windows;
  KOKKOS_FUNCTION void operator()(int eight) const {
    for (int q = 1; q < Q; ++q)
      windows(eight * nodes_per_window + q - 1) =
          source_window(&source(q * capacity + eight * nodes_per_window), q * capacity, capacity);
  }
};

void rebuild_links(const Exec& exec, FluidNodes& nodes) {
  for_each_node(exec, "vug::fluid_nodes::build_links", nodes.count,
                BuildLinks{nodes.lattice, nodes.periodic[0], nodes.periodic[1], nodes.capacity, nodes.node, nodes.index,
                           nodes.source, nodes.solid_links, nodes.side_links, nodes.open_links});
  if constexpr (has_source_windows)
    for_each_node(exec, "vug::fluid_nodes::build_windows", nodes.count / nodes_per_window,
                  BuildWindows{nodes.capacity, nodes.source, nodes.windows});
}

namespace {

void allocate(const Exec& exec, FluidNodes& nodes, int capacity) {
  nodes.capacity = round_capacity(capacity);
  Kokkos::resize(exec, nodes.node, nodes.capacity);
  const auto fresh = [&](const char* name) {
    return Kokkos::view_alloc(exec, std::string("vug::fluid_nodes::") + name);
  };
  nodes.source = IndexList(fresh("source"), static_cast<std::size_t>(Q) * nodes.capacity);
  if constexpr (has_source_windows) nodes.windows = Kokkos::View<SourceWindow*>(fresh("windows"), nodes.capacity);
  nodes.solid_links = Kokkos::View<std::uint16_t*>(fresh("solid_links"), nodes.capacity);
  nodes.side_links = Kokkos::View<std::uint16_t*>(fresh("side_links"), nodes.capacity);
  nodes.open_links = Kokkos::View<std::uint16_t*>(fresh("open_links"), nodes.capacity);
}

}  // namespace

/// The index before any node is numbered.
struct MarkOpenings {
  Kokkos::View<const NodeType*> type;
  IndexList index;
  KOKKOS_FUNCTION void operator()(int n) const { index(n) = type(n) == NodeType::opening ? in_opening : -1; }
};

FluidNodes make_fluid_nodes(const Exec& exec, const Lattice& lattice, const Kokkos::View<NodeType*>& type,
                            std::array<bool, 2> periodic) {
  FluidNodes nodes;
  nodes.lattice = lattice;
  nodes.periodic = periodic;
  nodes.node = IndexList("vug::fluid_nodes::node", 0);
  nodes.index = IndexList("vug::fluid_nodes::index", lattice.size());
  for_each_node(exec, "vug::fluid_nodes::number_none", lattice.size(), MarkOpenings{type, nodes.index});
  append_births(exec, type, nodes);
  if (nodes.count == 0) allocate(exec, nodes, 16);
  return nodes;
}

int append_births(const Exec& exec, const Kokkos::View<NodeType*>& type, FluidNodes& nodes) {
  const Lattice& lattice = nodes.lattice;
  const Kokkos::RangePolicy<Exec> interior(exec, 0, lattice.nx * lattice.ny);
  int births = 0;
  Kokkos::parallel_reduce("vug::fluid_nodes::count_births", interior, CountUnnumbered{lattice, type, nodes.index},
                          births);
  if (births == 0) return 0;
  const int count = nodes.count + births;
  // The first numbering is as tight as it gets; later ones leave room so that growth is rare.
  if (count > nodes.capacity) allocate(exec, nodes, nodes.count == 0 ? count : count + count / 2);
  Kokkos::parallel_scan("vug::fluid_nodes::number", interior,
                        NumberFluid{lattice, type, nodes.node, nodes.index, nodes.count});
  nodes.count = count;
  rebuild_links(exec, nodes);
  return births;
}

struct ForgetNumbers {
  IndexList index;
  KOKKOS_FUNCTION void operator()(int n) const { index(n) = index(n) == in_opening ? in_opening : -1; }
};

struct IndexOfNode {
  IndexList node, index;
  KOKKOS_FUNCTION void operator()(int i) const { index(node(i)) = i; }
};

void set_fluid_nodes(const Exec& exec, const IndexList& node, int capacity, FluidNodes& nodes) {
  nodes.count = static_cast<int>(node.extent(0));
  allocate(exec, nodes, capacity);
  Kokkos::deep_copy(exec, Kokkos::subview(nodes.node, std::pair(0, nodes.count)), node);
  for_each_node(exec, "vug::fluid_nodes::forget", nodes.lattice.size(), ForgetNumbers{nodes.index});
  for_each_node(exec, "vug::fluid_nodes::index", nodes.count, IndexOfNode{nodes.node, nodes.index});
  rebuild_links(exec, nodes);
}

template <class T>
struct Restride {
  Kokkos::View<const T*> source;
  ScalarField<T> target;
  int count, from, to;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int q = item / count;
    const int i = item % count;
    target(q * to + i) = source(q * from + i);
  }
};

template <class T>
ScalarField<T> restride(const Exec& exec, const ScalarField<T>& populations, int directions, int count, int from,
                        int to) {
  ScalarField<T> moved(Kokkos::view_alloc(exec, populations.label()), static_cast<std::size_t>(directions) * to);
  for_each_node(exec, "vug::fluid_nodes::restride", directions * count,
                Restride<T>{populations, moved, count, from, to});
  return moved;
}

template ScalarField<float> restride(const Exec&, const ScalarField<float>&, int, int, int, int);
template ScalarField<double> restride(const Exec&, const ScalarField<double>&, int, int, int, int);

}  // namespace vug
