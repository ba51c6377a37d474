#include "dem/gauges.hpp"

#include "dem/thermal_strain.hpp"
#include "kernels/launch/launch.hpp"

#include <limits>

namespace vug {

namespace {

struct PointDisplacement {
  Particles p;
  double expansion;
  RockPoint point;
  ScalarField<double> out;
  KOKKOS_FUNCTION void operator()(int) const {
    const int i = point.particle;
    const double scale = thermal_scale(expansion, p.warming(i));
    const Vec2 arm = (scale - 1) * point.arm + scale * Rotation{p.rotation(i, 0), p.rotation(i, 1)}.move(point.arm) -
                     Rotation::by(p.angle_origin(i)).move(point.arm);
    out(0) = p.u(i, 0) - p.u_origin(i, 0) + arm.x;
    out(1) = p.u(i, 1) - p.u_origin(i, 1) + arm.y;
  }
};

struct ReactionOf {
  Particles p;
  IndexList held;
  int axis;
  KOKKOS_FUNCTION double operator()(int k) const { return p.reaction(held(k), axis); }
};

/// Position of an end of the edge of a bond, in the undeformed rock, m.
KOKKOS_FORCEINLINE_FUNCTION Vec2 end_of_edge(const Particles& p, const Bonds& bonds, int k, int end) {
  const int a = bonds.pair(k, 0);
  const Vec2 first{bonds.arm(k, 0, 0, 0), bonds.arm(k, 0, 0, 1)}, second{bonds.arm(k, 1, 0, 0), bonds.arm(k, 1, 0, 1)};
  const Vec2 half = (0.5 / gauss_point) * (second - first);
  return Vec2{p.x0(a, 0), p.x0(a, 1)} + 0.5 * (first + second) + (end == 0 ? -1.0 : 1.0) * half;
}

struct FurthestEnd {
  Particles p;
  Bonds bonds;
  Vec2 direction;
  KOKKOS_FUNCTION double along(int k, int end) const { return dot(end_of_edge(p, bonds, k, end), direction); }
  KOKKOS_FUNCTION void operator()(int k, double& largest) const {
    if (!has_failed(bonds.state(k))) return;
    largest = Kokkos::max(largest, Kokkos::max(along(k, 0), along(k, 1)));
  }
};

/// First end (2 * bond + end) that lies as far as `reached`.
struct FirstEnd {
  FurthestEnd of;
  double reached;
  KOKKOS_FUNCTION void operator()(int k, int& first) const {
    if (!has_failed(of.bonds.state(k))) return;
    for (int end = 0; end < 2; ++end)
      if (of.along(k, end) >= reached && 2 * k + end < first) first = 2 * k + end;
  }
};

struct CopyEnd {
  Particles p;
  Bonds bonds;
  int end;
  ScalarField<double> out;
  KOKKOS_FUNCTION void operator()(int) const {
    const Vec2 place = end_of_edge(p, bonds, end / 2, end % 2);
    out(0) = place.x;
    out(1) = place.y;
  }
};

Vec2 read(const Exec& exec, const ScalarField<double>& out) {
  exec.fence("vug::dem::gauge");
  const auto host = on_host(out);
  return {host(0), host(1)};
}

}  // namespace

Vec2 displacement_of(const Exec& exec, const Particles& particles, double expansion, const RockPoint& point) {
  const ScalarField<double> out("vug::dem::gauge", 2);
  for_each_node(exec, "vug::dem::gauge_displacement", 1, PointDisplacement{particles, expansion, point, out});
  return read(exec, out);
}

Vec2 reaction_of(const Exec& exec, const Particles& particles, const std::array<IndexList, 2>& held) {
  const auto sum = [&](int axis) {
    const IndexList& members = held[axis];
    return sum_of_list(exec, "vug::dem::gauge_reaction", static_cast<int>(members.extent(0)),
                       ReactionOf{particles, members, axis});
  };
  return {sum(0), sum(1)};
}

Vec2 furthest_crack_tip(const Exec& exec, const Particles& particles, const Bonds& bonds, Vec2 from, Vec2 direction) {
  const FurthestEnd furthest{particles, bonds, direction};
  const Kokkos::RangePolicy<Exec> all(exec, 0, bonds.count);
  double reached = 0;
  Kokkos::parallel_reduce("vug::dem::gauge_crack_tip", all, furthest, Kokkos::Max<double>(reached));
  if (!(reached > dot(from, direction))) return from;
  int first = std::numeric_limits<int>::max();
  Kokkos::parallel_reduce("vug::dem::gauge_crack_tip", all, FirstEnd{furthest, reached}, Kokkos::Min<int>(first));
  if (first == std::numeric_limits<int>::max()) return from;
  const ScalarField<double> out("vug::dem::gauge", 2);
  for_each_node(exec, "vug::dem::gauge_crack_tip_place", 1, CopyEnd{particles, bonds, first, out});
  return read(exec, out);
}

}  // namespace vug
