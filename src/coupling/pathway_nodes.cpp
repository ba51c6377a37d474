// The nodes that pathways open, and which part of them slits fill.
#include "coupling/pathway_widths.hpp"
#include "coupling/rock_pathways.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace vug {

namespace {

/// Slope of the edge of each bond to the axis that it follows more closely.
std::vector<double> slopes_of(const Assembly& assembly, const BondEdges& bonds) {
  std::vector<double> slopes;
  for (const auto& [p, q] : bonds.vertices) {
    const double x = std::abs(assembly.vertices[q][0] - assembly.vertices[p][0]);
    const double y = std::abs(assembly.vertices[q][1] - assembly.vertices[p][1]);
    slopes.push_back(std::min(x, y) / std::max(x, y));
  }
  return slopes;
}

using Point = std::array<double, 2>;

/// Length of the line from p to q, in cells, inside the cell at (x, y).
double length_in_cell(const Point& p, const Point& q, const Point& cell) {
  double from = 0, to = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = q[axis] - p[axis], low = cell[axis] - p[axis], high = low + 1;
    if (way == 0 && (low > 0 || high < 0)) return 0;
    if (way == 0) continue;
    from = std::max(from, std::min(low / way, high / way));
    to = std::min(to, std::max(low / way, high / way));
  }
  return std::max(0.0, to - from) * std::hypot(q[0] - p[0], q[1] - p[1]);
}

/// Part of each cell (node of the lattice) that is filled by pathways narrower than a cell: what they have in it. What
/// exceeds the cell fills the other cells of the strip.
std::map<int, double> filled_by_slits(const Scene& scene, const Assembly& assembly, const BondEdges& bonds,
                                      const std::vector<std::vector<StripNode>>& strips,
                                      const std::vector<double>& closed, const std::vector<double>& slope) {
  const PathwayWidths widths(scene);
  const auto corner = [&](int v) {
    return Point{assembly.vertices[v][0] / scene.lattice.spacing, assembly.vertices[v][1] / scene.lattice.spacing};
  };
  std::map<int, double> filled;
  std::vector<std::vector<int>> nodes(strips.size());
  for (std::size_t b = 0; b < strips.size(); ++b) {
    if (!widths.drags(closed[b], slope[b])) continue;
    const Point p = corner(bonds.vertices[b][0]), q = corner(bonds.vertices[b][1]);
    for (const StripNode& entry : strips[b]) {
      if (entry.aperture > widths.strip(closed[b])) continue;
      const int x = entry.node % scene.lattice.nx, y = entry.node / scene.lattice.nx;
      nodes[b].push_back(entry.node);
      filled[entry.node] += closed[b] * length_in_cell(p, q, {static_cast<double>(x), static_cast<double>(y)});
    }
  }
  for (const std::vector<int>& strip : nodes) {
    double over = 0, room = 0;
    for (const int n : strip) (filled[n] > 1 ? over : room) += std::abs(filled[n] - 1);
    const double part = over < room ? over / room : 1;
    for (const int n : strip) filled[n] = filled[n] > 1 ? 1 : filled[n] + part * (1 - filled[n]);
  }
  return filled;
}

}  // namespace

PathwayNodes pathway_nodes(const Scene& scene, const Lattice& lattice, const Assembly& assembly, const BondEdges& bonds,
                           const RockRaster& raster, const std::vector<double>& closed,
                           const std::vector<bool>& solid) {
  const PathwayWidths widths(scene);
  std::vector<double> open(closed.size());
  const bool added = scene.damage->widening == PathwayWidening::added;
  for (std::size_t b = 0; b < open.size(); ++b) {
    const double by_damage = scene.damage->pathway_factor * bonds.spacing[b] / scene.lattice.spacing;
    open[b] = std::max({added ? closed[b] + by_damage : by_damage, widths.of_broken, closed[b]});
  }
  const auto strips = bond_strips(scene, lattice, assembly, bonds, raster, open);
  const std::vector<double> slope = slopes_of(assembly, bonds);
  std::vector<bool> wanted = solid;
  for (std::size_t b = 0; b < strips.size(); ++b)
    if (widths.drags(closed[b], slope[b]))
      for (const StripNode& entry : strips[b]) wanted[entry.node] = true;
  std::map<int, std::vector<std::pair<int, double>>> of_node;  // bonds, in ascending order, with the apertures
  for (std::size_t b = 0; b < strips.size(); ++b)
    for (const StripNode& entry : strips[b])
      if (wanted[entry.node]) of_node[entry.node].emplace_back(static_cast<int>(b), entry.aperture);
  const std::map<int, double> filled_by = filled_by_slits(scene, assembly, bonds, strips, closed, slope);
  std::vector<int> node, offset{0}, bond;
  std::vector<double> aperture, filled;
  std::vector<std::vector<int>> of_triangle(assembly.triangles.size());
  for (const auto& [n, entries] : of_node) {
    of_triangle[raster.owner[n]].push_back(static_cast<int>(node.size()));
    node.push_back(lattice.node(n % lattice.nx, n / lattice.nx));
    const auto by_slits = filled_by.find(n);
    filled.push_back(by_slits == filled_by.end() ? 1 : std::min(1.0, by_slits->second));
    for (const auto& [b, least] : entries) {
      bond.push_back(b);
      aperture.push_back(least);
    }
    offset.push_back(static_cast<int>(bond.size()));
  }
  std::vector<int> in_order, first{0};
  for (const std::vector<int>& candidates : of_triangle) {
    in_order.insert(in_order.end(), candidates.begin(), candidates.end());
    first.push_back(static_cast<int>(in_order.size()));
  }
  return {.node = to_device<IndexList>("vug::pathways::node", node),
          .offset = to_device<IndexList>("vug::pathways::offset", offset),
          .bond = to_device<IndexList>("vug::pathways::bond", bond),
          .least = to_device<ScalarField<double>>("vug::pathways::least_aperture", aperture),
          .closed = to_device<ScalarField<double>>("vug::pathways::closed", closed),
          .open = to_device<ScalarField<double>>("vug::pathways::open", open),
          .cubic = widths.cubic,
          .slope = to_device<ScalarField<double>>("vug::pathways::slope", slope),
          .filled = to_device<ScalarField<double>>("vug::pathways::filled", filled),
          .in_order = to_device<IndexList>("vug::pathways::in_order", in_order),
          .first = to_device<IndexList>("vug::pathways::first", first)};
}

}  // namespace vug
