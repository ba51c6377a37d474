#include "coupling/wet_nodes.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

struct MarkSurface {
  IndexList surface;
  Kokkos::View<std::uint8_t*> wet;
  std::uint8_t mark;
  KOKKOS_FUNCTION void operator()(int s) const { wet(surface(s)) = mark; }
};

struct CountWetNodes {
  NodeGroups nodes;
  Kokkos::View<const std::uint8_t*> wet;
  IndexList of_sector;
  KOKKOS_FUNCTION void operator()(int s) const {
    int count = 0;
    nodes.for_each(s, [&](int n) { count += wet(n); });
    of_sector(s + 1) = count;
  }
};

struct ListWetNodes {
  NodeGroups nodes;
  Kokkos::View<const std::uint8_t*> wet;
  IndexList of_sector, of_triangle, node;
  KOKKOS_FUNCTION void operator()(int s) const {
    int at = of_sector(s);
    if (at < of_sector(s + 1))
      nodes.for_each(s, [&](int n) {
        if (wet(n)) node(at++) = n;
      });
    if (s % 3 == 2) of_triangle(s / 3 + 1) = of_sector(s + 1);
  }
};

WetNodes::WetNodes(const Lattice& lattice, const NodeGroups& nodes_of_sector)
    : nodes_of_sector_(nodes_of_sector),
      of_sector_("vug::wet_nodes::of_sector", nodes_of_sector.count() + 1),
      of_triangle_("vug::wet_nodes::of_triangle", nodes_of_sector.count() / 3 + 1),
      wet_("vug::wet_nodes::wet", lattice.size()) {}

void WetNodes::find(const Exec& exec, const Surface& surface) {
  const auto mark = [&](std::uint8_t value) {
    for_each_node(exec, "vug::wet_nodes::mark", surface.count, MarkSurface{surface.node, wet_, value});
  };
  mark(1);
  for_each_node(exec, "vug::wet_nodes::count", sectors(), CountWetNodes{nodes_of_sector_, wet_, of_sector_});
  const int count = accumulate_counts(exec, "vug::wet_nodes::places", of_sector_);
  if (static_cast<int>(node_.extent(0)) < count) node_ = IndexList("vug::wet_nodes::node", count + count / 2);
  for_each_node(exec, "vug::wet_nodes::list", sectors(),
                ListWetNodes{nodes_of_sector_, wet_, of_sector_, of_triangle_, node_});
  mark(0);
}

}  // namespace vug
