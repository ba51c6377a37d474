// The boundary of a list of fluid nodes: the surface of the rock, and the links through the sides of the lattice.
#include "base/unroll.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/nodes/marked_nodes.hpp"

#include <bit>

namespace vug {

namespace {

/// Whether a node is solid and has a fluid node among its eight neighbours. Has no branch where no sides are joined.
template <bool joined>
struct IsSurface {
  DenseNeighbour around;
  Kokkos::View<const NodeType*> type;
  IndexList index;
  KOKKOS_FUNCTION bool operator()(int n) const {
    int highest = -1;
    VUG_UNROLL
    for (int q = 1; q < D2Q9::Q; ++q) {
      const int i = joined ? around.fluid_along(index, n, q) : index(n + around.lattice.offset(q));
      highest = i > highest ? i : highest;
    }
    return (type(n) == NodeType::solid) & (highest >= 0);
  }
};

struct ListNode {
  IndexList list;
  KOKKOS_FUNCTION void operator()(int k, int n) const { list(k) = n; }
};

}  // namespace

void find_surface(const Exec& exec, const FluidNodes& nodes, const Kokkos::View<NodeType*>& type, Surface& surface) {
  const char* label = "vug::fluid_nodes::surface";
  const DenseNeighbour around = nodes.around();
  const NodeMarks marks = around.periodic_x || around.periodic_y
                              ? mark_nodes(exec, label, nodes.lattice, IsSurface<true>{around, type, nodes.index})
                              : mark_nodes(exec, label, nodes.lattice, IsSurface<false>{around, type, nodes.index});
  surface.count = count_marked(exec, label, marks);
  if (surface.count > static_cast<int>(surface.node.extent(0)))
    surface.node = IndexList(label, surface.count + surface.count / 2);
  take_marked(exec, label, marks, ListNode{surface.node});
}

/// Collects the links out of one stretch of a side.
struct CollectLinks {
  Lattice lattice;
  bool periodic_x, periodic_y;
  Side side;
  int first, directions;
  Side order[4];
  IndexList index, fluid;
  Kokkos::View<std::uint8_t*> direction;

  /// True when velocity q leaves through `s` from node (x, y).
  KOKKOS_FUNCTION bool leaves(Side s, int x, int y, int q) const {
    switch (s) {
      case Side::left:
        return !periodic_x && x + D2Q9::c(q, 0) < 0;
      case Side::right:
        return !periodic_x && x + D2Q9::c(q, 0) >= lattice.nx;
      case Side::bottom:
        return !periodic_y && y + D2Q9::c(q, 1) < 0;
      default:
        return !periodic_y && y + D2Q9::c(q, 1) >= lattice.ny;
    }
  }
  KOKKOS_FUNCTION bool belongs(int x, int y, int q) const {
    if (!leaves(side, x, y, q)) return false;
    for (const Side s : order) {
      if (s == side) return true;
      if (leaves(s, x, y, q)) return false;
    }
    return false;
  }
  KOKKOS_FUNCTION void operator()(int item, int& running, bool last) const {
    const int along = first + item;
    const bool upright = side == Side::left || side == Side::right;
    const int x = side == Side::left ? 0 : side == Side::right ? lattice.nx - 1 : along;
    const int y = upright ? along : side == Side::bottom ? 0 : lattice.ny - 1;
    const int i = index(lattice.node(x, y));
    if (i < 0) return;
    for (int q = 1; q < directions; ++q) {
      if (!belongs(x, y, q)) continue;
      if (last) {
        fluid(running) = i;
        direction(running) = static_cast<std::uint8_t>(q);
      }
      ++running;
    }
  }
};

BoundaryLinks find_boundary_links(const Exec& exec, const FluidNodes& nodes, Side side, int first, int last,
                                  int directions, const SideOrder& order) {
  BoundaryLinks links;
  const int length = last - first + 1;
  if (length <= 0) return links;
  links.fluid = IndexList("vug::fluid_nodes::boundary_fluid", 3 * length);
  links.direction = Kokkos::View<std::uint8_t*>("vug::fluid_nodes::boundary_direction", 3 * length);
  Kokkos::parallel_scan("vug::fluid_nodes::collect_links", Kokkos::RangePolicy<Exec>(exec, 0, length),
                        CollectLinks{nodes.lattice,
                                     nodes.periodic[0],
                                     nodes.periodic[1],
                                     side,
                                     first,
                                     directions,
                                     {order[0], order[1], order[2], order[3]},
                                     nodes.index,
                                     links.fluid,
                                     links.direction},
                        links.count);
  return links;
}

ScalarField<double> link_areas(const BoundaryLinks& links, int directions,
                               const std::function<double(int, int)>& facing) {
  const ScalarField<double> area("vug::fluid_nodes::link_area", links.count);
  const auto direction = on_host(links.direction);
  const HostWriter host(area);
  double straight = 0, all = 0;
  for (int link = 0; link < links.count; ++link) {
    const int q = direction(link);
    const double across = facing(link, q);
    host(link) = 6 * (directions == D2Q9::Q ? D2Q9::w(q) : D2Q5::w(q)) * across;
    all += host(link);
    if (q < D2Q5::Q) straight += across;
  }
  for (int link = 0; link < links.count; ++link) host(link) *= straight / all;
  return area;
}

/// Marks a link: sets its bit in the word that holds the masks of two nodes, atomically because two links may share it.
struct MarkOpen {
  static_assert(std::endian::native == std::endian::little);
  IndexList fluid;
  Kokkos::View<std::uint8_t*> direction;
  unsigned* masks;
  KOKKOS_FUNCTION void operator()(int link) const {
    const int i = fluid(link);
    Kokkos::atomic_or(masks + i / 2, 1u << (direction(link) + 16 * (i % 2)));
  }
};

void mark_open(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links) {
  KOKKOS_ASSERT(nodes.open_links.extent(0) % 2 == 0);
  for_each_node<false>(exec, "vug::fluid_nodes::mark_open", links.count,
                       MarkOpen{links.fluid, links.direction, reinterpret_cast<unsigned*>(nodes.open_links.data())});
}

}  // namespace vug
