#pragma once
// Delaunay triangulation of points in a rectangle, with exact integers.
#include <array>
#include <cstdint>
#include <vector>

namespace vug::detail {

using Point = std::array<double, 2>;

/// The rectangle [0, length] on a grid of integers. Its spacing, 1e-8 of the longer side, is so fine that snapping
/// points to it does no harm and so coarse that every predicate is exact.
struct IntegerGrid {
  Point length;
  std::array<std::int32_t, 2> size;

  explicit IntegerGrid(Point length_);
  std::array<std::int32_t, 2> snap(Point p) const;
};

/// Triangles, counter-clockwise, of the Delaunay triangulation; empty when they do not tile the convex hull exactly
/// (coinciding points). The four corners of the rectangle must be among the points.
std::vector<std::array<int, 3>> delaunay(const IntegerGrid& grid, const std::vector<Point>& points);

}  // namespace vug::detail
