#pragma once
// Rock of a few triangles given by hand, and which nodes lie in them by plain geometry.
#include "support/temporary_folder.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <vector>

namespace vug::test {

using Point = std::array<double, 2>;
using Corners = std::array<int, 3>;

/// A Gmsh file of triangles, counter-clockwise, m.
inline std::string mesh_text(const std::vector<Point>& vertices, const std::vector<Corners>& triangles) {
  std::string text = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    text += fmt::format("{} {:.17g} {:.17g} 0\n", v + 1, vertices[v][0], vertices[v][1]);
  text += fmt::format("$EndNodes\n$Elements\n{}\n", triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    text += fmt::format("{} 2 2 1 1 {} {} {}\n", t + 1, triangles[t][0] + 1, triangles[t][1] + 1, triangles[t][2] + 1);
  return text + "$EndElements\n";
}

/// Twice the signed area of a, b, c.
inline double double_area(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

inline Point centroid(const Point& a, const Point& b, const Point& c) {
  return {(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
}

/// Centres of the nodes, `spacing` apart, that lie in the triangle a, b, c, counter-clockwise.
inline std::vector<Point> nodes_inside(const Point& a, const Point& b, const Point& c, int nx, int ny, double spacing) {
  std::vector<Point> found;
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) {
      const Point p{(x + 0.5) * spacing, (y + 0.5) * spacing};
      if (double_area(a, b, p) > 0 && double_area(b, c, p) > 0 && double_area(c, a, p) > 0) found.push_back(p);
    }
  return found;
}

}  // namespace vug::test
