#include "kernels/nodes/opening.hpp"

#include <cmath>

namespace vug {

Opening make_opening(const Lattice& lattice, const std::vector<int>& nodes, const OutlineNormal& normal, double scale) {
  constexpr int links = D2Q9::Q - 1;
  Opening opening{IndexList("vug::opening::node", nodes.size()),
                  ScalarField<double>("vug::opening::facing", links * nodes.size())};
  const HostWriter node(opening.node);
  const HostWriter facing(opening.facing);
  for (std::size_t item = 0; item < nodes.size(); ++item) {
    node(item) = nodes[item];
    for (int q = 1; q < D2Q9::Q; ++q) {
      const std::array<double, 2> c{double(D2Q9::c(q, 0)), double(D2Q9::c(q, 1))};
      const auto n = normal({lattice.x(nodes[item]) + 0.5 * (1 + c[0]), lattice.y(nodes[item]) + 0.5 * (1 + c[1])}, c);
      facing(links * item + q - 1) = scale * std::abs(n[0] * c[0] + n[1] * c[1]);
    }
  }
  return opening;
}

/// Collects the links into an opening from the nodes that have a number: `number` (dense node), negative for none.
struct CollectOpeningLinks {
  DenseNeighbour around;
  int directions;
  IndexList opening, number, from, item, beyond;
  Kokkos::View<std::uint8_t*> direction;
  KOKKOS_FUNCTION void operator()(int k, int& running, bool last) const {
    for (int q = 1; q < directions; ++q) {
      const int there = around.along(opening(k), q);
      if (there < 0 || number(there) < 0) continue;
      if (last) {
        from(running) = number(there);
        item(running) = k;
        beyond(running) = opening(k);
        direction(running) = static_cast<std::uint8_t>(D2Q9::opposite(q));
      }
      ++running;
    }
  }
};

namespace {

struct FoundLinks {
  BoundaryLinks links;
  IndexList item, beyond;  ///< (link) item of the opening and its node
};

FoundLinks find_links(const Exec& exec, const DenseNeighbour& around, const IndexList& number, const Opening& opening,
                      int directions) {
  FoundLinks found;
  const std::size_t nodes = opening.node.extent(0), most = (directions - 1) * nodes;
  found.links.fluid = IndexList("vug::opening::fluid", most);
  found.links.direction = Kokkos::View<std::uint8_t*>("vug::opening::direction", most);
  found.item = IndexList("vug::opening::item", most);
  found.beyond = IndexList("vug::opening::beyond", most);
  Kokkos::parallel_scan("vug::opening::collect_links", Kokkos::RangePolicy<Exec>(exec, 0, nodes),
                        CollectOpeningLinks{around, directions, opening.node, number, found.links.fluid, found.item,
                                            found.beyond, found.links.direction},
                        found.links.count);
  return found;
}

ScalarField<double> areas(const FoundLinks& found, const Opening& opening, int directions) {
  const auto item = on_host(found.item);
  const auto facing = on_host(opening.facing);
  return link_areas(found.links, directions,
                    [&](int link, int q) { return facing((D2Q9::Q - 1) * item(link) + D2Q9::opposite(q) - 1); });
}

/// (dense node) The node itself as its number; -1 in an opening.
IndexList dense_numbers(const Lattice& lattice, const Kokkos::View<NodeType*>& type) {
  IndexList number("vug::opening::number", lattice.size());
  const auto host_type = on_host(type);
  const HostWriter host(number);
  for (int n = 0; n < lattice.size(); ++n) host(n) = host_type(n) == NodeType::opening ? -1 : n;
  return number;
}

}  // namespace

BoundaryLinks find_opening_links(const Exec& exec, const FluidNodes& nodes, const Opening& opening, int directions) {
  return find_links(exec, nodes.around(), nodes.index, opening, directions).links;
}

ScalarField<double> link_areas(const Exec& exec, const FluidNodes& nodes, const Opening& opening, int directions) {
  return areas(find_links(exec, nodes.around(), nodes.index, opening, directions), opening, directions);
}

DenseLinks find_dense_opening_links(const Exec& exec, const Lattice& lattice, std::array<bool, 2> periodic,
                                    const Kokkos::View<NodeType*>& type, const Opening& opening, int directions) {
  const FoundLinks found = find_links(exec, {lattice, periodic}, dense_numbers(lattice, type), opening, directions);
  const BoundaryLinks& links = found.links;
  return {links.count, links.fluid, found.beyond, links.direction, areas(found, opening, directions)};
}

}  // namespace vug
