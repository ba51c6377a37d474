#include "coupling/velocity_profile.hpp"

#include "kernels/launch/launch.hpp"

#include <algorithm>

namespace vug {

namespace {

TimeTable curve(const FlowBoundary& flow) {
  std::vector<double> at, share;
  for (const auto& [x, value] : flow.profile_table) {
    at.push_back(x);
    share.push_back(value);
  }
  return {at, share};
}

}  // namespace

double share_of_velocity(const FlowBoundary& flow, double at, double length) {
  switch (flow.profile) {
    case VelocityShape::parabolic: {
      const double x = std::clamp(at / length, 0.0, 1.0);
      return 6 * x * (1 - x);
    }
    case VelocityShape::table:
      return curve(flow).at(at);
    case VelocityShape::uniform:
      break;
  }
  return 1;
}

double share_of_cell(const FlowBoundary& flow, int cell, int cells, double spacing) {
  const auto share = [&](double at) { return share_of_velocity(flow, at * spacing, cells * spacing); };
  return (share(cell) + 4 * share(cell + 0.5) + share(cell + 1)) / 6;
}

double largest_share(const FlowBoundary& flow) {
  if (flow.profile == VelocityShape::table) return std::abs(curve(flow).peak());
  return flow.profile == VelocityShape::parabolic ? 1.5 : 1.0;
}

double mean_share(const FlowBoundary& flow, const Stretch& stretch, double spacing) {
  const int cells = stretch.last + 1 - stretch.first, before = stretch.first - stretch.whole_first;
  const bool all_of_parabola = flow.profile == VelocityShape::parabolic && cells == stretch.whole_length();
  if (flow.profile == VelocityShape::uniform || all_of_parabola) return 1;
  constexpr int samples = 1000;
  const double length = cells * spacing, whole = stretch.whole_length() * spacing;
  double sum = 0;
  for (int i = 0; i < samples; ++i)
    sum += share_of_velocity(flow, before * spacing + (i + 0.5) / samples * length, whole);
  return sum / samples;
}

/// Where a link crosses a side: half a link from its node, cells along the side.
struct CrossingOfLink {
  Lattice lattice;
  bool upright;
  IndexList node, fluid;
  Kokkos::View<const std::uint8_t*> direction;
  ScalarField<double> at;
  KOKKOS_FUNCTION void operator()(int link) const {
    const int n = node(fluid(link)), q = direction(link);
    at(link) = 0.5 + (upright ? lattice.y(n) + 0.5 * D2Q9::c(q, 1) : lattice.x(n) + 0.5 * D2Q9::c(q, 0));
  }
};

ScalarField<double> shares_at_links(const Exec& exec, const FluidNodes& fluid, const StretchLinks& boundary,
                                    double spacing) {
  const Stretch& stretch = boundary.stretch;
  const FlowBoundary& flow = stretch.conditions.flow;
  if (stretch.opening || flow.profile == VelocityShape::uniform) return {};
  const BoundaryLinks& links = boundary.links;
  const ScalarField<double> share("vug::velocity_profile::share", links.count);
  for_each_node(
      exec, "vug::velocity_profile::crossing", links.count,
      CrossingOfLink{fluid.lattice, is_upright(stretch.side), fluid.node, links.fluid, links.direction, share});
  const auto host = on_host(share);
  const double length = stretch.whole_length() * spacing;
  for (int link = 0; link < links.count; ++link)
    host(link) = share_of_velocity(flow, (host(link) - stretch.whole_first) * spacing, length);
  Kokkos::deep_copy(share, host);
  return share;
}

double inflow_per_speed(const StretchLinks& boundary) {
  if (boundary.stretch.opening) return sum_in_order(boundary.area);
  const auto direction = on_host(boundary.links.direction);
  const auto share = on_host(boundary.share);
  const int outward = static_cast<int>(boundary.stretch.side);
  double volume = 0;
  for (int link = 0; link < boundary.links.count; ++link) {
    const int q = direction(link);
    const int across = D2Q9::c(q, 0) * D2Q9::c(outward, 0) + D2Q9::c(q, 1) * D2Q9::c(outward, 1);
    volume += 6 * D2Q9::w(q) * across * (share.extent(0) > 0 ? share(link) : 1.0);
  }
  for (const StretchEnd& end : boundary.ends)  // its fluid there enters by a link of the stretch beyond the corner
    if (end.beyond == StretchEnd::Beyond::corner && end.link < 0) volume += 6 * D2Q9::w(D2Q5::Q) * end.share;
  return volume;
}

}  // namespace vug
