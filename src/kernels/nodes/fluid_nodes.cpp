#include "kernels/nodes/fluid_nodes.hpp"

#include "base/lattice_size.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/marked_nodes.hpp"

namespace vug {

namespace {

constexpr int Q = D2Q9::Q;
static_assert(Q - 1 == nodes_per_window, "as many windows as nodes");

int round_capacity(int count) {
  return (count + 15) / 16 * 16;
}

}  // namespace

/// Whether a node is fluid and not in the list yet.
struct IsUnnumbered {
  Kokkos::View<const NodeType*> type;
  IndexList index;
  KOKKOS_FUNCTION bool operator()(int n) const { return (type(n) == NodeType::fluid) & (index(n) < 0); }
};

/// Appends a node to the list, whose last number was first - 1.
struct NumberFluid {
  IndexList node, index;
  int first;
  KOKKOS_FUNCTION void operator()(int k, int n) const {
    node(first + k) = n;
    index(n) = first + k;
  }
};

/// Sets the sources of one fluid node, walls included, and the masks that say what lies beyond each of its links.
struct BuildLinks {
  DenseNeighbour around;
  int capacity;
  IndexList node, index, source;
  Kokkos::View<std::uint16_t*> solid_links, side_links, open_links;
  KOKKOS_FUNCTION void operator()(int i) const {
    unsigned solid = 0, side = 0;
    source(i) = i;
    for (int q = 1; q < Q; ++q) {
      const int opposite = D2Q9::opposite(q);
      const int beyond = around.along(node(i), q);
      const int upstream = around.along(node(i), opposite);
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

/// Builds the windows of eight nodes in all directions.
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

namespace {

BuildLinks build_links(const FluidNodes& nodes) {
  return {nodes.around(), nodes.capacity,    nodes.node,       nodes.index,
          nodes.source,   nodes.solid_links, nodes.side_links, nodes.open_links};
}

BuildWindows build_windows(const FluidNodes& nodes) {
  return {nodes.capacity, nodes.source, nodes.windows};
}

}  // namespace

void rebuild_links(const Exec& exec, FluidNodes& nodes) {
  for_each_node(exec, "vug::fluid_nodes::build_links", nodes.count, build_links(nodes));
  if constexpr (has_source_windows)
    for_each_node(exec, "vug::fluid_nodes::build_windows", nodes.count / nodes_per_window, build_windows(nodes));
}

/// Builds the tables of newborn nodes [first, last) and of the fluid nodes around them, one after the other because
/// newborns may share neighbours.
struct LinkNewborns {
  BuildLinks links;
  BuildWindows windows;
  int first, last;

  template <class Visit>
  KOKKOS_FUNCTION void visit_touched(const Visit& visit) const {
    for (int i = first; i < last; ++i) {
      visit(i);
      for (int q = 1; q < Q; ++q) {
        const int n = links.around.along(links.node(i), q);
        if (n >= 0 && links.index(n) >= 0) visit(links.index(n));
      }
    }
  }
  KOKKOS_FUNCTION void operator()(int) const {
    visit_touched([this](int i) { links(i); });
    if constexpr (has_source_windows)
      visit_touched([this](int i) {
        if (const int eight = i / nodes_per_window; (eight + 1) * nodes_per_window <= last) windows(eight);
      });
  }
};

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

/// Initialises the index before any node is numbered.
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
  const char* label = "vug::fluid_nodes::births";
  const NodeMarks marks = mark_nodes(exec, label, nodes.lattice, IsUnnumbered{type, nodes.index});
  const int births = count_marked(exec, label, marks);
  if (births == 0) return 0;
  const int first = nodes.count, last = first + births;
  const bool grows = last > nodes.capacity;
  // The first numbering leaves no spare room; later ones do, so that growth is rare.
  if (grows) allocate(exec, nodes, first == 0 ? last : grown_capacity(nodes.lattice.nx, nodes.lattice.ny, last));
  take_marked(exec, label, marks, NumberFluid{nodes.node, nodes.index, first});
  nodes.count = last;
  constexpr int few = 1000;  // on a GPU one thread takes longer for these than all threads for all nodes
  if (runs_on_host && !grows && births <= few)
    Kokkos::parallel_for("vug::fluid_nodes::link_newborns", Kokkos::RangePolicy<Exec>(exec, 0, 1),
                         LinkNewborns{build_links(nodes), build_windows(nodes), first, last});
  else
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

VUG_COMPILE_FOR_NUMBERS(restride)

}  // namespace vug
