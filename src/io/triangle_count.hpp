#pragma once
// How many triangles a generated rock has, before it is generated.
#include <cmath>

namespace vug {

/// More than a lattice of the largest size has a use for.
inline constexpr double most_triangles = 1 << 22;

/// Triangles of mean edge `edge` (m) that an area (m2) holds, when they are equilateral: area / (sqrt(3)/4 edge²).
inline double triangles_in(double area, double edge) {
  return area / (std::sqrt(3.0) / 4 * edge * edge);
}

}  // namespace vug
