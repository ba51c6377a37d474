#include "io/detail/poisson_disc.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::detail {

namespace {

// A random direction: a point of the unit disc, scaled to length 1. A sine's last bit would depend on the C library.
Point direction(CounterRandom& random) {
  while (true) {
    const double x = 2 * random.uniform() - 1;
    const double y = 2 * random.uniform() - 1;
    const double square = x * x + y * y;
    if (square > 1 || square < 1e-4) continue;
    const double norm = std::sqrt(square);
    return {x / norm, y / norm};
  }
}

}  // namespace

KeepOut::KeepOut(Point length, double reach) : width_(reach), cells_{} {
  for (int axis = 0; axis < 2; ++axis) cells_[axis] = std::max(1, static_cast<int>(length[axis] / reach) + 1);
  places_.resize(static_cast<std::size_t>(cells_[0]) * cells_[1]);
}

int KeepOut::cell(double coordinate, int axis) const {
  return std::clamp(static_cast<int>(std::floor(coordinate / width_)), 0, cells_[axis] - 1);
}

void KeepOut::add(const Place& place) {
  places_[static_cast<std::size_t>(cell(place.centre[1], 1)) * cells_[0] + cell(place.centre[0], 0)].push_back(place);
}

bool KeepOut::allows(Point p, double spacing) const {
  const int cx = cell(p[0], 0), cy = cell(p[1], 1);
  for (int y = std::max(0, cy - 1); y <= std::min(cells_[1] - 1, cy + 1); ++y) {
    for (int x = std::max(0, cx - 1); x <= std::min(cells_[0] - 1, cx + 1); ++x) {
      for (const Place& place : places_[static_cast<std::size_t>(y) * cells_[0] + x]) {
        const double dx = p[0] - place.centre[0], dy = p[1] - place.centre[1];
        const double kept = place.own + place.share * spacing;
        if (dx * dx + dy * dy < kept * kept) return false;
      }
    }
  }
  return true;
}

void fill_with_points(std::vector<Point>& points, KeepOut& keep_out, const std::function<double(Point)>& spacing,
                      const std::function<bool(Point)>& inside, CounterRandom random) {
  constexpr int tries = 30;
  std::vector<std::size_t> active(points.size());
  std::iota(active.begin(), active.end(), std::size_t{0});
  while (!active.empty()) {
    const auto pick = static_cast<std::size_t>(random.next() % active.size());
    const Point from = points[active[pick]];
    bool found = false;
    for (int k = 0; k < tries && !found; ++k) {
      const Point along = direction(random);
      // Just outside the distance to be kept: this gives a dense, even packing without gaps that become obtuse
      // triangles.
      const double distance = spacing(from) * (1 + 0.25 * random.uniform());
      const Point p{from[0] + distance * along[0], from[1] + distance * along[1]};
      if (!inside(p) || !keep_out.allows(p, spacing(p))) continue;
      keep_out.add_point(p, spacing(p));
      active.push_back(points.size());
      points.push_back(p);
      found = true;
    }
    if (!found) {
      active[pick] = active.back();
      active.pop_back();
    }
  }
}

}  // namespace vug::detail
