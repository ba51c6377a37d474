#pragma once
// Straight lines of an outline.
#include "io/detail/delaunay.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::detail {

struct Line {
  Point from, to;
  bool notch = false;
  int shape = 0;  ///< index in Outline::shapes
  Point at(double t) const { return {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}; }
};

inline double distance(Point a, Point b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  return std::sqrt(dx * dx + dy * dy);
}

/// Position (0 to 1) on the line of the point nearest to p.
inline double nearest(const Line& line, Point p) {
  const double dx = line.to[0] - line.from[0], dy = line.to[1] - line.from[1];
  const double square = dx * dx + dy * dy;
  if (square == 0) return 0;
  return std::clamp(((p[0] - line.from[0]) * dx + (p[1] - line.from[1]) * dy) / square, 0.0, 1.0);
}

inline double distance(const Line& line, Point p) {
  return distance(line.at(nearest(line, p)), p);
}

/// The lines between the corners of a closed polygon.
inline std::vector<Line> lines_around(const std::vector<Point>& corners, int shape = 0) {
  std::vector<Line> lines;
  for (std::size_t a = 0; a < corners.size(); ++a)
    lines.push_back({corners[a], corners[(a + 1) % corners.size()], false, shape});
  return lines;
}

}  // namespace vug::detail
