#include "io/detail/disc_outline.hpp"

#include "io/detail/circle.hpp"

#include <algorithm>
#include <cmath>

namespace vug::detail {

DiscOutline disc_outline(double diameter, double flat_width, double edge) {
  const double radius = diameter / 2, half_flat = flat_width * radius;
  const double half_height = std::sqrt(radius * radius - half_flat * half_flat);
  const Point centre{radius, half_height};
  DiscOutline disc{{diameter, 2 * half_height}, {}};
  Outline& outline = disc.outline;
  outline.round = true;
  outline.shapes = {"the rim of the disc"};
  outline.points = {{0, 0}, {diameter, 0}, disc.length, {0, 2 * half_height}};
  const double low = arc_tangent(half_height / (radius + half_flat));
  // share = 0 at the flank, 1 at the end of the flat
  const auto on_arc = [&](double share) { return on_circle(radius, tangent(share * low)); };
  const auto parts = [edge](double length) { return std::max(2L, std::lround(length / edge)); };
  const long arc = parts(2 * low * radius), flat = parts(2 * half_flat);
  std::vector<Point> quarter;  // from the flank up to the end of the flat, relative to the centre
  for (long i = 0; i <= arc; ++i) quarter.push_back(on_arc(static_cast<double>(i) / static_cast<double>(arc)));
  quarter.back() = {half_flat, half_height};
  std::vector<Point> ring;
  for (long i = 0; i < arc; ++i) ring.push_back(quarter[static_cast<std::size_t>(i)]);
  for (long i = 0; i < flat; ++i)
    ring.push_back({half_flat * (1 - 2 * static_cast<double>(i) / static_cast<double>(flat)), half_height});
  for (long i = arc; i > 0; --i)
    ring.push_back({-quarter[static_cast<std::size_t>(i)][0], quarter[static_cast<std::size_t>(i)][1]});
  const auto half = ring.size();
  for (std::size_t i = 0; i < half; ++i) ring.push_back({-ring[i][0], -ring[i][1]});
  const int first = static_cast<int>(outline.points.size());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    outline.points.push_back({centre[0] + ring[i][0], centre[1] + ring[i][1]});
    outline.edges.push_back({first + static_cast<int>(i), first + static_cast<int>((i + 1) % ring.size()), false, 0});
  }
  return disc;
}

}  // namespace vug::detail
