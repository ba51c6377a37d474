#include "dem/mean_stress.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

namespace {

/// Stress of one triangle times its area, and that area.
struct StressTimesArea {
  Particles particles;
  Bonds bonds;
  ForceMoments outer;  ///< may be empty

  KOKKOS_FUNCTION double area(int i) const {
    const auto corner = [&](int c) { return Vec2{particles.corner(i, c, 0), particles.corner(i, c, 1)}; };
    return 0.5 * cross(corner(1) - corner(0), corner(2) - corner(0));
  }
  KOKKOS_FUNCTION Stress operator()(int i) const {
    Stress sum;
    double held = 0;
    if (outer.extent(0) > 0) {
      sum = {outer(i, 0), outer(i, 2), outer(i, 1)};
      held = outer(i, 3);
    }
    for (int e = bonds.row(i); e < bonds.row(i + 1); ++e) {
      const int k = bonds.entry(e) / 2, end = bonds.entry(e) % 2;
      const double sign = end == 0 ? 1 : -1;
      const Vec2 middle{0.5 * (bonds.arm(k, 0, end, 0) + bonds.arm(k, 1, end, 0)),
                        0.5 * (bonds.arm(k, 0, end, 1) + bonds.arm(k, 1, end, 1))};
      const Vec2 force{sign * bonds.load(k, 0), sign * bonds.load(k, 1)};
      if (held != 0) sum.xy += held * bonds.load(k, 2 + end);
      sum.xx += middle.x * force.x;
      sum.xy += 0.5 * (middle.x * force.y + middle.y * force.x);
      sum.yy += middle.y * force.y;
    }
    return sum;
  }
};

struct StressOfTriangle {
  StressTimesArea of;
  Kokkos::View<double* [3], Kokkos::LayoutLeft> stress;
  KOKKOS_FUNCTION void operator()(int i) const {
    const Stress sum = of(i);
    const double area = of.area(i);
    stress(i, 0) = sum.xx / area;
    stress(i, 1) = sum.yy / area;
    stress(i, 2) = sum.xy / area;
  }
};

/// One number of one member: 0 xx, 1 yy, 2 xy, each times the area; 3 the area.
struct ShareOfMember {
  StressTimesArea of;
  IndexList members;
  int component;
  KOKKOS_FUNCTION double operator()(int m) const {
    const int i = members(m);
    if (component == 3) return of.area(i);
    const Stress sum = of(i);
    return component == 0 ? sum.xx : component == 1 ? sum.yy : sum.xy;
  }
};

}  // namespace

Kokkos::View<double* [3], Kokkos::LayoutLeft> stress_of_triangles(const Exec& exec, const Particles& particles,
                                                                  const Bonds& bonds, const ForceMoments& outer) {
  const Kokkos::View<double* [3], Kokkos::LayoutLeft> stress("vug::dem::triangle_stress", particles.count);
  for_each_node(exec, "vug::dem::stress_of_triangles", particles.count,
                StressOfTriangle{{particles, bonds, outer}, stress});
  exec.fence("vug::dem::stress_of_triangles");
  return stress;
}

Stress mean_stress(const Exec& exec, const Particles& particles, const Bonds& bonds, const IndexList& members,
                   const ForceMoments& outer) {
  const int count = static_cast<int>(members.extent(0));
  const auto sum = [&](int component) {
    return sum_of_list(exec, "vug::dem::mean_stress", count,
                       ShareOfMember{{particles, bonds, outer}, members, component});
  };
  const double area = sum(3);
  return {sum(0) / area, sum(2) / area, sum(1) / area};
}

Stress mean_stress(const Particles& particles, const Bonds& bonds, const std::vector<int>& members,
                   const ForceMoments& outer) {
  return mean_stress(Exec(), particles, bonds, to_device<IndexList>("vug::dem::mean_stress_members", members), outer);
}

}  // namespace vug
