#include "io/detail/delaunay.hpp"

#include <boost/polygon/voronoi.hpp>

#include <algorithm>
#include <cmath>

namespace vug::detail {

namespace {
using Integer = std::array<std::int32_t, 2>;

// Twice the signed area; the coordinates are below 2^27, so it is exact.
std::int64_t cross(const Integer& a, const Integer& b, const Integer& c) {
  const std::int64_t abx = b[0] - a[0], aby = b[1] - a[1];
  const std::int64_t acx = c[0] - a[0], acy = c[1] - a[1];
  return abx * acy - aby * acx;
}
}  // namespace

IntegerGrid::IntegerGrid(Point length_) : length(length_), size{} {
  const double quantum = std::max(length[0], length[1]) / (1 << 26);
  for (int axis = 0; axis < 2; ++axis) size[axis] = static_cast<std::int32_t>(std::lround(length[axis] / quantum));
}

Integer IntegerGrid::snap(Point p) const {
  Integer out{};
  for (int axis = 0; axis < 2; ++axis) {
    const double share = std::clamp(p[axis] / length[axis], 0.0, 1.0);
    out[axis] = static_cast<std::int32_t>(std::lround(share * size[axis]));
  }
  return out;
}

std::vector<std::array<int, 3>> delaunay(const IntegerGrid& grid, const std::vector<Point>& points) {
  std::vector<Integer> snapped;
  std::vector<boost::polygon::point_data<std::int32_t>> sites;
  for (const Point& p : points) {
    snapped.push_back(grid.snap(p));
    sites.emplace_back(snapped.back()[0], snapped.back()[1]);
  }
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(sites.begin(), sites.end(), &diagram);

  // Every Voronoi vertex is the circumcentre of a triangle (or of a polygon of cocircular points) of the cells around
  // it.
  std::vector<std::array<int, 3>> triangles;
  std::int64_t area = 0;
  for (const auto& vertex : diagram.vertices()) {
    std::vector<int> ring;
    const auto* edge = vertex.incident_edge();
    do {
      ring.push_back(static_cast<int>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    for (std::size_t k = 1; k + 1 < ring.size(); ++k) {
      std::array<int, 3> triangle{ring[0], ring[k], ring[k + 1]};
      std::int64_t twice = cross(snapped[triangle[0]], snapped[triangle[1]], snapped[triangle[2]]);
      if (twice < 0) std::swap(triangle[1], triangle[2]);
      area += std::abs(twice);
      if (twice != 0) triangles.push_back(triangle);
    }
  }
  if (area != 2 * static_cast<std::int64_t>(grid.size[0]) * grid.size[1]) return {};
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace vug::detail
