#pragma once
// Small assemblies and host access for the tests of the mechanics.
#include "dem/heterogeneity.hpp"
#include "dem/mechanics.hpp"
#include "support/host_copy.hpp"

#include <cmath>
#include <vector>

namespace vug::test {

/// One with legs l, its right angle at the origin.
inline Assembly right_triangle(double l) {
  return {{{0, 0}, {l, 0}, {0, l}}, {{0, 1, 2}}, {}};
}

/// Two equilateral triangles of edge l that share the edge from (0, 0) to (0, l); a on the left, n = +x.
inline Assembly pair_of_triangles(double l) {
  const double height = l * std::sqrt(3.0) / 2;
  return {{{0, 0}, {0, l}, {-height, l / 2}, {height, l / 2}}, {{0, 1, 2}, {0, 3, 1}}, {}};
}

/// A width × height block of triangles with edges of about l, interior vertices displaced by up to `jitter` l.
inline Assembly block(double width, double height, double l, double jitter, std::uint64_t seed = 1) {
  const int rows = static_cast<int>(std::lround(height / (l * std::sqrt(3.0) / 2)));
  const int columns = static_cast<int>(std::lround(width / l));
  const double dx = width / columns, dy = height / rows;
  Assembly out;
  std::vector<std::vector<int>> row(static_cast<std::size_t>(rows) + 1);
  for (int r = 0; r <= rows; ++r) {
    const bool shifted = r % 2 == 1;
    for (int c = 0; c <= columns + (shifted ? 1 : 0); ++c) {
      const auto name = static_cast<int>(out.vertices.size());
      out.vertices.push_back({shifted ? std::min(width, std::max(0.0, (c - 0.5) * dx)) : c * dx, r * dy});
      row[static_cast<std::size_t>(r)].push_back(name);
    }
  }
  for (std::size_t r = 0; r < row.size() - 1; ++r) {
    const auto &low = row[r], &high = row[r + 1];
    std::size_t i = 0, j = 0;
    while (i + 1 < low.size() || j + 1 < high.size()) {
      const bool up =
          i + 1 == low.size() || (j + 1 < high.size() && out.vertices[static_cast<std::size_t>(high[j + 1])][0] <
                                                             out.vertices[static_cast<std::size_t>(low[i + 1])][0]);
      if (up) {
        out.triangles.push_back({low[i], high[j + 1], high[j]});
        ++j;
      } else {
        out.triangles.push_back({low[i], low[i + 1], high[j]});
        ++i;
      }
    }
  }
  for (std::size_t name = 0; name < out.vertices.size(); ++name) {
    auto& [x, y] = out.vertices[name];
    if (x < 0.6 * dx || x > width - 0.6 * dx || y < 0.1 * dy || y > height - 0.1 * dy) continue;
    x += jitter * dx * (2 * uniform_of(seed, name, 0, 0) - 1);
    y += jitter * dy * (2 * uniform_of(seed, name, 1, 0) - 1);
  }
  return out;
}

/// Contacts that bear next to nothing, bonds without scatter and dashpots.
inline MechanicsParameters nearly_free() {
  MechanicsParameters p;
  p.contact.normal_stiffness = p.contact.tangential_stiffness = 1e-3;
  p.contact.normal_damping = p.contact.tangential_damping = 0;
  p.bond.damping = 0;
  p.bond.weibull_shape = 0;
  return p;
}

/// Rock that does not break and whose bonds take no energy.
inline MechanicsParameters elastic(double local_damping = 0) {
  MechanicsParameters p;
  p.bond.normal_strength = p.bond.cohesion = 1e15;
  p.bond.damping = 0;
  p.local_damping = local_damping;
  return p;
}

/// Displaces one particle (from the assembly) and lets it rest there.
inline void place(const Particles& p, int i, double ux, double uy, double angle = 0) {
  const auto u = host_copy(p.u);
  const auto q = host_copy(p.angle);
  const auto rotation = host_copy(p.rotation);
  u(i, 0) = ux;
  u(i, 1) = uy;
  q(i) = angle;
  rotation(i, 0) = Rotation::by(angle).cos_minus_1;
  rotation(i, 1) = Rotation::by(angle).sin;
  Kokkos::deep_copy(p.u, u);
  Kokkos::deep_copy(p.angle, q);
  Kokkos::deep_copy(p.rotation, rotation);
}

/// Momenta of the whole assembly at the half step, about the origin.
struct Momenta {
  double x = 0, y = 0, angular = 0, scale = 0;
};

inline Momenta momenta(const Particles& p, double dt) {
  const auto x0 = host_copy(p.x0), u = host_copy(p.u), v = host_copy(p.v);
  const auto spin = host_copy(p.spin), mass = host_copy(p.mass), inertia = host_copy(p.inertia);
  Momenta sum;
  for (int i = 0; i < p.count; ++i) {
    // positions are half a step ahead of velocities; x × v does not change along v, so no correction is needed
    const double x = x0(i, 0) + u(i, 0) - 0.5 * dt * v(i, 0), y = x0(i, 1) + u(i, 1) - 0.5 * dt * v(i, 1);
    sum.x += mass(i) * v(i, 0);
    sum.y += mass(i) * v(i, 1);
    sum.angular += mass(i) * (x * v(i, 1) - y * v(i, 0)) + inertia(i) * spin(i);
    sum.scale += std::abs(mass(i) * (x * v(i, 1) - y * v(i, 0))) + std::abs(inertia(i) * spin(i));
  }
  return sum;
}

}  // namespace vug::test
