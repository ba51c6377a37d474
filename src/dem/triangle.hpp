#pragma once
// Geometry of one triangle (docs/model.md, particles): all of the shape that a rigid sphero-triangle needs.
#include "base/base.hpp"

namespace vug {

/// A point or a vector in the plane, m.
struct Vec2 {
  double x = 0;
  double y = 0;
};

KOKKOS_FORCEINLINE_FUNCTION constexpr Vec2 operator+(Vec2 a, Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
KOKKOS_FORCEINLINE_FUNCTION constexpr Vec2 operator-(Vec2 a, Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
KOKKOS_FORCEINLINE_FUNCTION constexpr Vec2 operator*(double s, Vec2 a) {
  return {s * a.x, s * a.y};
}
KOKKOS_FORCEINLINE_FUNCTION constexpr double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
KOKKOS_FORCEINLINE_FUNCTION constexpr double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
KOKKOS_FORCEINLINE_FUNCTION double norm(Vec2 a) {
  return Kokkos::sqrt(dot(a, a));
}
/// Velocity of the end of lever arm r at spin omega: omega × r.
KOKKOS_FORCEINLINE_FUNCTION constexpr Vec2 spin_times(double omega, Vec2 r) {
  return {-omega * r.y, omega * r.x};
}

/// A rotation stored as its difference from the identity, so that small angles keep all their digits.
struct Rotation {
  double cos_minus_1 = 0;
  double sin = 0;

  /// Computed from the half angle, whose sine and cosine come from series about the nearest multiple of pi/2 (error
  /// below 2e-16). The series are written out because a call of the library would keep the loop over particles from
  /// being vectorised.
  KOKKOS_FORCEINLINE_FUNCTION static Rotation by(double angle) {
    constexpr double quarter = 1.57079632679489661923, rest = 6.123233995736766e-17;  // pi/2 in two parts
    const double half = 0.5 * angle, turns = Kokkos::floor(half / quarter + 0.5);
    const double r = (half - turns * quarter) - turns * rest, r2 = r * r;
    const double sine =
        r + r * r2 *
                (-1.0 / 6 +
                 r2 * (1.0 / 120 +
                       r2 * (-1.0 / 5040 + r2 * (1.0 / 362880 + r2 * (-1.0 / 39916800 +
                                                                      r2 * (1.0 / 6227020800 - r2 / 1307674368000))))));
    const double cosine =
        1 + r2 * (-0.5 +
                  r2 * (1.0 / 24 +
                        r2 * (-1.0 / 720 +
                              r2 * (1.0 / 40320 + r2 * (-1.0 / 3628800 + r2 * (1.0 / 479001600 - r2 / 87178291200))))));
    // sine and cosine of the half angle up to a common sign, which cancels in the products below
    const double odd = turns - 2 * Kokkos::floor(0.5 * turns);
    const double s = odd > 0 ? cosine : sine, c = odd > 0 ? -sine : cosine;
    return {-2 * s * s, 2 * s * c};
  }
  /// (Q - 1) r: displacement of the end of r by the rotation.
  KOKKOS_FORCEINLINE_FUNCTION Vec2 move(Vec2 r) const {
    return {cos_minus_1 * r.x - sin * r.y, sin * r.x + cos_minus_1 * r.y};
  }
  /// Q r.
  KOKKOS_FORCEINLINE_FUNCTION Vec2 turn(Vec2 r) const { return r + move(r); }
};

/// Three corners in counter-clockwise order.
struct Triangle {
  Vec2 corner[3];

  /// Signed area, m2: positive when the corners are counter-clockwise.
  KOKKOS_FUNCTION double area() const { return 0.5 * cross(corner[1] - corner[0], corner[2] - corner[0]); }
  KOKKOS_FUNCTION Vec2 centroid() const { return (1.0 / 3.0) * (corner[0] + corner[1] + corner[2]); }
  KOKKOS_FUNCTION double side(int k) const { return norm(corner[(k + 1) % 3] - corner[k]); }
  KOKKOS_FUNCTION double perimeter() const { return side(0) + side(1) + side(2); }
  /// Polar moment of inertia about the centroid per unit of mass, m2: (a2 + b2 + c2) / 36.
  KOKKOS_FUNCTION double gyration_squared() const {
    double sum = 0;
    for (int k = 0; k < 3; ++k) sum += dot(corner[(k + 1) % 3] - corner[k], corner[(k + 1) % 3] - corner[k]);
    return sum / 36;
  }
  /// Radius of the inscribed circle, m.
  KOKKOS_FUNCTION double inradius() const { return 2 * area() / perimeter(); }
  /// Centre of the inscribed circle.
  KOKKOS_FUNCTION Vec2 incentre() const {
    const double p = perimeter();
    return (side(1) / p) * corner[0] + (side(2) / p) * corner[1] + (side(0) / p) * corner[2];
  }
  /// Largest distance of a corner from the centroid, m.
  KOKKOS_FUNCTION double reach() const {
    const Vec2 c = centroid();
    return Kokkos::max(norm(corner[0] - c), Kokkos::max(norm(corner[1] - c), norm(corner[2] - c)));
  }
  /// Corner k of the triangle whose edges lie a distance `radius` further inside, which is similar to this one about
  /// the incentre. Dilated by a disc of that radius it gives the sphero-triangle, which touches the edges of this
  /// triangle.
  KOKKOS_FUNCTION Vec2 eroded_corner(int k, double radius) const {
    const Vec2 c = incentre();
    return c + (1 - radius / inradius()) * (corner[k] - c);
  }
};

}  // namespace vug
