#include "dem/mean_stress.hpp"

namespace vug {

Stress mean_stress(const Particles& particles, const Bonds& bonds, const std::vector<int>& members) {
  const auto copy = [](const auto& view) { return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view); };
  const auto row = copy(bonds.row), entry = copy(bonds.entry);
  const auto arm = copy(bonds.arm);
  const auto load = copy(bonds.load);
  const auto corner = copy(particles.corner);
  Stress sum;
  double area = 0;
  for (const int i : members) {
    const Vec2 a{corner(i, 0, 0), corner(i, 0, 1)}, b{corner(i, 1, 0), corner(i, 1, 1)},
        c{corner(i, 2, 0), corner(i, 2, 1)};
    area += 0.5 * cross(b - a, c - a);
    for (int e = row(i); e < row(i + 1); ++e) {
      const int k = entry(e) / 2, end = entry(e) % 2;
      const double sign = end == 0 ? 1 : -1;
      const Vec2 middle{0.5 * (arm(k, 0, end, 0) + arm(k, 1, end, 0)), 0.5 * (arm(k, 0, end, 1) + arm(k, 1, end, 1))};
      const Vec2 force{sign * load(k, 0), sign * load(k, 1)};
      sum.xx += middle.x * force.x;
      sum.xy += 0.5 * (middle.x * force.y + middle.y * force.x);
      sum.yy += middle.y * force.y;
    }
  }
  return {sum.xx / area, sum.xy / area, sum.yy / area};
}

}  // namespace vug
