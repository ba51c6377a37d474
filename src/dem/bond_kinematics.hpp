#pragma once
// Relative displacement and velocity of the two faces of a bond at its integration points.
#include "dem/bonds.hpp"
#include "dem/thermal_strain.hpp"

namespace vug {

/// Motion of the particle at one end of a bond.
struct EndMotion {
  Vec2 u;       ///< displacement, m
  Vec2 v;       ///< velocity, m/s
  double spin;  ///< 1/s
  Rotation rotation;
  double scale;  ///< thermal scale of lever arms

  /// Displacement of the end of lever arm r (body frame).
  KOKKOS_FORCEINLINE_FUNCTION Vec2 displacement_at(Vec2 r) const {
    return u + (scale - 1) * r + scale * rotation.move(r);
  }
};

KOKKOS_FORCEINLINE_FUNCTION EndMotion motion_of(const Particles& p, double expansion, int i) {
  return {{p.u(i, 0), p.u(i, 1)},
          {p.v(i, 0), p.v(i, 1)},
          p.spin(i),
          {p.rotation(i, 0), p.rotation(i, 1)},
          thermal_scale(expansion, p.warming(i))};
}

/// The same one step dt earlier, that is before the displacement by the present velocity.
KOKKOS_FORCEINLINE_FUNCTION EndMotion motion_before(const Particles& p, double expansion, double dt, int i) {
  EndMotion m = motion_of(p, expansion, i);
  m.u = m.u - dt * m.v;
  m.rotation = Rotation::by(p.angle(i) - dt * m.spin);
  return m;
}

/// Current normal and tangent of a bond: mean of the edge's directions as turned by its two ends.
struct BondFrame {
  double n_x, n_y;

  KOKKOS_FORCEINLINE_FUNCTION Vec2 n() const { return {n_x, n_y}; }
  KOKKOS_FORCEINLINE_FUNCTION Vec2 t() const { return {-n_y, n_x}; }
};

KOKKOS_FORCEINLINE_FUNCTION BondFrame frame_of(Vec2 normal, const Rotation& a, const Rotation& b) {
  const Vec2 sum = normal + 0.5 * (a.move(normal) + b.move(normal));
  const double scale = 1 / norm(sum);
  return {scale * sum.x, scale * sum.y};
}

/// Opening of one integration point, its rate, and the lever arms of its midpoint. Equal and opposite forces act at
/// this point, on one line, so that linear and angular momentum are conserved exactly and the elastic forces have a
/// potential.
struct PointOpening {
  double delta_n, delta_t;
  double rate_n, rate_t;
  Vec2 arm_a, arm_b;
};

KOKKOS_FORCEINLINE_FUNCTION PointOpening opening_of(const EndMotion& a, const EndMotion& b, Vec2 r_a, Vec2 r_b,
                                                    const BondFrame& frame) {
  const Vec2 delta = b.displacement_at(r_b) - a.displacement_at(r_a);
  const Vec2 arm_a = a.scale * a.rotation.turn(r_a) + 0.5 * delta;
  const Vec2 arm_b = b.scale * b.rotation.turn(r_b) - 0.5 * delta;
  const Vec2 rate = b.v + spin_times(b.spin, arm_b) - a.v - spin_times(a.spin, arm_a);
  return {dot(delta, frame.n()), dot(delta, frame.t()), dot(rate, frame.n()), dot(rate, frame.t()), arm_a, arm_b};
}

/// Frame and both points of one bond.
struct BondMotion {
  BondFrame frame;
  PointOpening opening[2];
};

KOKKOS_FORCEINLINE_FUNCTION Vec2 arm_of(const Bonds& bonds, int k, int point, int end) {
  return {bonds.arm(k, point, end, 0), bonds.arm(k, point, end, 1)};
}

KOKKOS_FORCEINLINE_FUNCTION BondMotion motion_of_bond(const EndMotion& a, const EndMotion& b, const Bonds& bonds,
                                                      int k) {
  const BondFrame frame = frame_of({bonds.normal(k, 0), bonds.normal(k, 1)}, a.rotation, b.rotation);
  // no loop over the two points: it would keep the loop over bonds from being vectorised
  return {{frame.n_x, frame.n_y},
          {opening_of(a, b, arm_of(bonds, k, 0, 0), arm_of(bonds, k, 0, 1), frame),
           opening_of(a, b, arm_of(bonds, k, 1, 0), arm_of(bonds, k, 1, 1), frame)}};
}

KOKKOS_FORCEINLINE_FUNCTION BondMotion motion_of_bond(const Particles& particles, const Bonds& bonds, double expansion,
                                                      int k) {
  const EndMotion a = motion_of(particles, expansion, bonds.pair(k, 0));
  const EndMotion b = motion_of(particles, expansion, bonds.pair(k, 1));
  return motion_of_bond(a, b, bonds, k);
}

/// The same one step dt earlier.
KOKKOS_FORCEINLINE_FUNCTION BondMotion motion_of_bond_before(const Particles& particles, const Bonds& bonds,
                                                             double expansion, double dt, int k) {
  const EndMotion a = motion_before(particles, expansion, dt, bonds.pair(k, 0));
  const EndMotion b = motion_before(particles, expansion, dt, bonds.pair(k, 1));
  return motion_of_bond(a, b, bonds, k);
}

}  // namespace vug
