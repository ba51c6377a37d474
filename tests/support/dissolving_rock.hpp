#pragma once
// Bonded rock that loses solid, without a lattice.
#include "dem_support.hpp"

#include <functional>

namespace vug::test {

/// How much of a piece of rock is left: 1 all, 0 nothing.
using Left = std::function<double(Vec2)>;

/// Mean of `left` over a triangle, by the centroids of 25 equal parts.
inline double mean_left(const Triangle& t, const Left& left) {
  constexpr int n = 5;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n - i; ++j)
      for (const int up : {1, 2}) {
        if (up == 2 && j == n - i - 1) continue;
        const double a = (i + up / 3.0) / n, b = (j + up / 3.0) / n;
        sum += left((1 - a - b) * t.corner[0] + a * t.corner[1] + b * t.corner[2]);
      }
  return sum / (n * n);
}

/// Dissolves rock as the lattice does, by the sectors between centroid and edge.
inline void dissolve(Mechanics& rock, double dt, const Assembly& assembly, const Left& left) {
  const Particles& particles = rock.particles();
  const Bonds& bonds = rock.bonds();
  const ScalarField<double> solid("solid", particles.count), d_c("d_c", bonds.count);
  const auto solid_host = Kokkos::create_mirror_view(solid), d_c_host = Kokkos::create_mirror_view(d_c);
  const auto point = [&](int v) { return Vec2{assembly.vertices[v][0], assembly.vertices[v][1]}; };
  for (int i = 0; i < particles.count; ++i) solid_host(i) = mean_left(triangle_of(assembly, i), left);
  const auto pair = host_copy(bonds.pair), vertex = host_copy(bonds.vertex);
  for (int k = 0; k < bonds.count; ++k) {
    double volume[2], share[2];
    for (int end = 0; end < 2; ++end) {
      const Triangle sector{{point(vertex(k, 0)), point(vertex(k, 1)), triangle_of(assembly, pair(k, end)).centroid()}};
      volume[end] = std::abs(sector.area());
      share[end] = side_left(mean_left(sector, left), solid_host(pair(k, end)));
    }
    d_c_host(k) = chemical_damage_of_sides(volume[0], share[0], volume[1], share[1]);
  }
  Kokkos::deep_copy(solid, solid_host);
  Kokkos::deep_copy(d_c, d_c_host);
  rock.dissolve(Exec(), dt, solid, d_c);
}

}  // namespace vug::test
