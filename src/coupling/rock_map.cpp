#include "coupling/rock_map.hpp"

#include "coupling/cells.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug {

namespace {

using Point = std::array<double, 2>;

double cross(const Point& o, const Point& a, const Point& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/// Whether p is left of the line a-b. A point on the line counts as moved right by an infinitesimal amount, and up by
/// an even smaller one. Of two triangles that share an edge exactly one then holds it, as the interval [low, high)
/// holds its lower bound.
bool lies_left(const Point& a, const Point& b, const Point& p) {
  const Point along{b[0] - a[0], b[1] - a[1]};
  const double offset = cross(a, b, p) / std::hypot(along[0], along[1]);
  if (std::abs(offset) > tie) return offset > 0;
  return std::abs(along[1]) > tie ? along[1] < 0 : along[0] > 0;
}

}  // namespace

RockRaster rasterise(const Assembly& assembly, const Lattice& lattice, double spacing) {
  const std::size_t nodes = static_cast<std::size_t>(lattice.nx) * lattice.ny;
  RockRaster raster{std::vector<int>(nodes, -1), std::vector<int>(nodes, -1)};
  for (std::size_t t = 0; t < assembly.triangles.size(); ++t) {
    std::array<Point, 3> v;
    for (int k = 0; k < 3; ++k) {
      const Point& p = assembly.vertices[assembly.triangles[t][k]];
      v[k] = {p[0] / spacing, p[1] / spacing};
    }
    const auto [x_low, x_high] = std::minmax({v[0][0], v[1][0], v[2][0]});
    const auto [y_low, y_high] = std::minmax({v[0][1], v[1][1], v[2][1]});
    const double area = cross(v[0], v[1], v[2]);
    for (int y = std::max(0, static_cast<int>(y_low - 0.5));
         y <= std::min<int>(lattice.ny - 1, static_cast<int>(y_high)); ++y)
      for (int x = std::max(0, static_cast<int>(x_low - 0.5));
           x <= std::min<int>(lattice.nx - 1, static_cast<int>(x_high)); ++x) {
        const std::size_t n = static_cast<std::size_t>(y) * lattice.nx + x;
        if (raster.owner[n] >= 0) continue;
        const Point p{x + 0.5, y + 0.5};
        if (!lies_left(v[0], v[1], p) || !lies_left(v[1], v[2], p) || !lies_left(v[2], v[0], p)) continue;
        // lambda[k]: barycentric coordinate opposite to the edge (k, k + 1)
        const std::array<double, 3> lambda{cross(v[0], v[1], p) / area, cross(v[1], v[2], p) / area,
                                           cross(v[2], v[0], p) / area};
        const auto smallest = std::min_element(lambda.begin(), lambda.end());
        raster.owner[n] = static_cast<int>(t);
        raster.edge[n] = static_cast<int>(smallest - lambda.begin());
      }
  }
  return raster;
}

NodeGroups group_nodes(const std::vector<int>& key, int groups, const Lattice& lattice) {
  const auto key_of = [&](int x, int y) { return key[static_cast<std::size_t>(y) * lattice.nx + x]; };
  const auto begins = [&](int x, int y) { return key_of(x, y) >= 0 && (x == 0 || key_of(x - 1, y) != key_of(x, y)); };
  const auto for_each_node = [&](const auto& visit) {
    for (int y = 0; y < lattice.ny; ++y)
      for (int x = 0; x < lattice.nx; ++x) visit(x, y);
  };
  std::vector<int> offset(groups + 1, 0), nodes(groups, 0);
  for_each_node([&](int x, int y) {
    if (begins(x, y)) ++offset[key_of(x, y) + 1];
  });
  std::partial_sum(offset.begin(), offset.end(), offset.begin());
  std::vector<int> first(offset[groups]), length(offset[groups]), next = offset;
  for_each_node([&](int x, int y) {
    const int g = key_of(x, y);
    if (g < 0) return;
    if (begins(x, y)) first[next[g]++] = lattice.node(x, y);
    ++length[next[g] - 1];
    ++nodes[g];
  });
  return {to_device<IndexList>("vug::rock_map::offset", offset), to_device<IndexList>("vug::rock_map::first", first),
          to_device<IndexList>("vug::rock_map::length", length), to_device<IndexList>("vug::rock_map::nodes", nodes)};
}

}  // namespace vug
