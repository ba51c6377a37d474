#pragma once
// Estimates the number of triangles of a generated rock.
#include <cmath>

namespace vug {

/// Largest number of triangles, more than a lattice of the largest size can use.
inline constexpr double most_triangles = 1 << 22;

/// Number of equilateral triangles of edge `edge` (m) in an area (m2): area / (sqrt(3)/4 edge²).
inline double triangles_in(double area, double edge) {
  return area / (std::sqrt(3.0) / 4 * edge * edge);
}

}  // namespace vug
