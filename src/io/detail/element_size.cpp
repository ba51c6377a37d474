#include "io/detail/element_size.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>

namespace vug::detail {

std::optional<OrderedRectangle> hole_in_rock(Point length, const RockSection& rock) {
  if (!rock.hole) return std::nullopt;
  OrderedRectangle box{};
  for (int axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax(rock.hole->from[axis], rock.hole->to[axis]);
    box.low[axis] = std::clamp(low, 0.0, length[axis]);
    box.high[axis] = std::clamp(high, 0.0, length[axis]);
    if (!(box.high[axis] > box.low[axis])) throw InputError("rock.hole: has no area inside the rock");
  }
  return box;
}

double distance_to_rim(const Polygon& polygon, Point p) {
  double least = -1;
  for (const Line& line : lines_around(polygon.points)) {
    const double d = distance(line, p);
    if (least < 0 || d < least) least = d;
  }
  return least;
}

ElementSize::ElementSize(Point length, const RockSection& rock)
    : hole_(hole_in_rock(length, rock)), notches_(rock.notches), grading_(rock.grading) {
  for (const Form& hole : rock.holes) holes_.push_back({outline_of(hole, rock.element_size / 4)});
  if (grading_ > 1 && !hole_ && holes_.empty() && notches_.empty())
    throw InputError("rock.grading: needs a hole or a notch at which the elements are finest");
  if (grading_ > 1)
    for (const Point corner : {Point{0, 0}, Point{length[0], 0}, length, Point{0, length[1]}})
      reach_ = std::max(reach_, distance(corner));
  // The number of edges per area goes as 1 / size²: their mean length is ∫ size^-1 / ∫ size^-2.
  constexpr int samples = 200;
  double sum1 = 0, sum2 = 0;
  for (int y = 0; y < samples; ++y) {
    for (int x = 0; x < samples; ++x) {
      const Point p{length[0] * (x + 0.5) / samples, length[1] * (y + 0.5) / samples};
      if (hole_ && hole_->contains(p, 0)) continue;
      if (std::any_of(holes_.begin(), holes_.end(), [&](const Polygon& hole) { return holds(hole, p, 0); })) continue;
      const double h = relative(p);
      sum1 += 1 / h;
      sum2 += 1 / (h * h);
    }
  }
  finest_ = rock.element_size * sum2 / sum1;
}

double ElementSize::distance(Point p) const {
  double least = -1;
  const auto note = [&least](double d) { least = least < 0 || d < least ? d : least; };
  if (hole_) {
    const double dx = std::max({hole_->low[0] - p[0], p[0] - hole_->high[0], 0.0});
    const double dy = std::max({hole_->low[1] - p[1], p[1] - hole_->high[1], 0.0});
    note(std::sqrt(dx * dx + dy * dy));
  }
  for (const Polygon& cut : holes_) note(holds(cut, p, 0) ? 0 : distance_to_rim(cut, p));
  if (least >= 0) return least;
  for (const Notch& notch : notches_) {
    note(detail::distance(Line{notch.from, notch.to, true}, p));
  }
  return least;
}

double ElementSize::relative(Point p) const {
  return grading_ > 1 ? 1 + (grading_ - 1) * std::min(1.0, distance(p) / reach_) : 1;
}

double ElementSize::operator()(Point p) const {
  return finest_ * relative(p);
}

}  // namespace vug::detail
