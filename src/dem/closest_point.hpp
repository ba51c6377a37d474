#pragma once
// The point of a triangle's outline that is closest to a given point.
#include "dem/triangle.hpp"

namespace vug {

/// Position of a point relative to the outline of a triangle.
struct ClosestPoint {
  double distance = 0;  ///< negative inside
  Vec2 normal;          ///< from the outline towards the point, outwards when inside
};

/// Closest point on the edge p -> q of a counter-clockwise triangle.
KOKKOS_FUNCTION inline ClosestPoint closest_on_edge(Vec2 p, Vec2 q, Vec2 point) {
  const Vec2 edge = q - p, from_p = point - p;
  const double length2 = dot(edge, edge), along = dot(from_p, edge);
  const Vec2 outward = (1 / Kokkos::sqrt(length2)) * Vec2{edge.y, -edge.x};
  if (along > 0 && along < length2) {
    const double height = dot(from_p, outward);
    return {height, outward};
  }
  const Vec2 gap = point - (along > 0 ? q : p);
  const double distance = norm(gap);
  return {distance, distance > 0 ? (1 / distance) * gap : outward};
}

/// Closest point on the outline of a counter-clockwise triangle. For a point inside, it is on the edge to which the
/// point has the least distance.
KOKKOS_FUNCTION inline ClosestPoint closest_on_triangle(const Triangle& t, Vec2 point) {
  ClosestPoint best[3];
  bool inside = true;
  for (int k = 0; k < 3; ++k) {
    const Vec2 p = t.corner[k], q = t.corner[(k + 1) % 3];
    best[k] = closest_on_edge(p, q, point);
    inside = inside && cross(q - p, point - p) > 0;
  }
  int chosen = 0;
  for (int k = 1; k < 3; ++k) {
    if (Kokkos::abs(best[k].distance) < Kokkos::abs(best[chosen].distance)) chosen = k;
  }
  if (!inside) best[chosen].distance = Kokkos::abs(best[chosen].distance);
  return best[chosen];
}

/// Whether the line of one of the edges of a (counter-clockwise) has every corner of b outside at a distance of more
/// than `gap`: then no point of b is closer to a. Cheap; misses only pairs whose closest points are a corner of each.
KOKKOS_FUNCTION inline bool keeps_clear(const Triangle& a, const Triangle& b, double gap) {
  for (int k = 0; k < 3; ++k) {
    const Vec2 p = a.corner[k], edge = a.corner[(k + 1) % 3] - p;
    double least = -cross(edge, b.corner[0] - p);
    for (int c = 1; c < 3; ++c) least = Kokkos::min(least, -cross(edge, b.corner[c] - p));
    if (least > 0 && least * least > gap * gap * dot(edge, edge)) return true;
  }
  return false;
}

}  // namespace vug
