#include "io/detail/rock_outline.hpp"

#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug::detail {

namespace {

struct Line {
  Point from, to;
  bool notch;
  Point at(double t) const { return {from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])}; }
};

double distance(Point a, Point b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  return std::sqrt(dx * dx + dy * dy);
}

// Position (0 to 1) on the line of the point nearest to p.
double nearest(const Line& line, Point p) {
  const double dx = line.to[0] - line.from[0], dy = line.to[1] - line.from[1];
  const double square = dx * dx + dy * dy;
  if (square == 0) return 0;
  return std::clamp(((p[0] - line.from[0]) * dx + (p[1] - line.from[1]) * dy) / square, 0.0, 1.0);
}

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

std::vector<Line> lines_around(const Polygon& polygon) {
  std::vector<Line> lines;
  const auto& v = polygon.points;
  for (std::size_t a = 0; a < v.size(); ++a) lines.push_back({v[a], v[(a + 1) % v.size()], false});
  return lines;
}

double distance_to_rim(const Polygon& polygon, Point p) {
  double least = -1;
  for (const Line& line : lines_around(polygon)) {
    const double d = distance(line.at(nearest(line, p)), p);
    if (least < 0 || d < least) least = d;
  }
  return least;
}

/// The corners of a form; those of a disc are about one local element size apart.
Polygon polygon_of(const Form& form, const ElementSize& size) {
  const auto* disc = std::get_if<Disc>(&form);
  return {outline_of(form, disc ? size({disc->centre[0] + disc->radius, disc->centre[1]}) : 1)};
}

std::vector<Line> box_lines(const OrderedRectangle& box) {
  const Point a = box.low, b{box.high[0], box.low[1]}, c = box.high, d{box.low[0], box.high[1]};
  return {{a, b, false}, {b, c, false}, {c, d, false}, {d, a, false}};
}

bool on_a_side(const Line& line, Point length) {
  for (int axis = 0; axis < 2; ++axis)
    for (const double side : {0.0, length[axis]})
      if (line.from[axis] == side && line.to[axis] == side) return true;
  return false;
}

// Moves a point of a side a little way into the rock.
Point moved_inside(Point p, Point length, double by) {
  for (int axis = 0; axis < 2; ++axis) p[axis] = std::clamp(p[axis], by, length[axis] - by);
  return p;
}

// Extends a notch that ends just short of a side or of the hole up to it; the gap would make very thin triangles.
Point attached(Point end, const std::vector<Line>& lines, const ElementSize& size) {
  Point best = end;
  double closest = 0.5 * size(end);
  for (const Line& line : lines) {
    const Point foot = line.at(nearest(line, end));
    if (distance(foot, end) < closest) {
      closest = distance(foot, end);
      best = foot;
    }
  }
  return best;
}

struct Meeting {
  double t;
  Point point;  // at an end exactly the end, without the rounding of an interpolation
};

// Where `line` meets the others, in order: crossings, and ends that are on it.
std::vector<Meeting> meetings(const Line& line, const std::vector<Line>& lines, double tolerance) {
  std::vector<Meeting> found{{0, line.from}, {1, line.to}};
  const double dx = line.to[0] - line.from[0], dy = line.to[1] - line.from[1];
  for (const Line& other : lines) {
    for (const Point end : {other.from, other.to})
      if (distance(line.at(nearest(line, end)), end) < tolerance) found.push_back({nearest(line, end), end});
    const double ex = other.to[0] - other.from[0], ey = other.to[1] - other.from[1];
    const double cross = dx * ey - dy * ex;
    if (std::abs(cross) < 1e-9 * std::sqrt((dx * dx + dy * dy) * (ex * ex + ey * ey))) continue;
    const double wx = other.from[0] - line.from[0], wy = other.from[1] - line.from[1];
    const double here = (wx * ey - wy * ex) / cross, there = (wx * dy - wy * dx) / cross;
    if (here > 0 && here < 1 && there > 0 && there < 1) found.push_back({here, line.at(here)});
  }
  std::stable_sort(found.begin(), found.end(), [](const Meeting& a, const Meeting& b) { return a.t < b.t; });
  return found;
}

int point_number(Outline& outline, Point p, double tolerance) {
  for (std::size_t i = 0; i < outline.points.size(); ++i)
    if (distance(outline.points[i], p) < tolerance) return static_cast<int>(i);
  outline.points.push_back(p);
  return static_cast<int>(outline.points.size()) - 1;
}

// Adds points between a and b that divide the integral of 1 / size into equal parts.
void divide(Outline& outline, int a, int b, bool notch, const ElementSize& size) {
  constexpr int samples = 1000;
  const Line line{outline.points[a], outline.points[b], notch};
  const double step = distance(line.from, line.to) / samples;
  std::vector<double> count(samples + 1, 0.0);
  for (int i = 0; i < samples; ++i) count[i + 1] = count[i] + step / size(line.at((i + 0.5) / samples));
  const int parts = std::max(1, static_cast<int>(std::ceil(count[samples] - 0.25)));
  int last = a;
  for (int part = 1, i = 0; part < parts; ++part) {
    const double wanted = count[samples] * part / parts;
    while (count[i + 1] < wanted) ++i;
    const double t = (i + (wanted - count[i]) / (count[i + 1] - count[i])) / samples;
    outline.points.push_back(line.at(t));
    const int next = static_cast<int>(outline.points.size()) - 1;
    outline.edges.push_back({last, next, notch});
    last = next;
  }
  outline.edges.push_back({last, b, notch});
}

}  // namespace

bool Outline::in_holes(Point p) const {
  return std::any_of(holes.begin(), holes.end(),
                     [&](const Polygon& cut) { return holds(cut, p, 0) && distance_to_rim(cut, p) > tie; });
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
    const Line line{notch.from, notch.to, true};
    note(detail::distance(line.at(nearest(line, p)), p));
  }
  return least;
}

double ElementSize::relative(Point p) const {
  return grading_ > 1 ? 1 + (grading_ - 1) * std::min(1.0, distance(p) / reach_) : 1;
}

double ElementSize::operator()(Point p) const {
  return finest_ * relative(p);
}

Outline rock_outline(Point length, const RockSection& rock, const ElementSize& size) {
  Outline outline;
  outline.hole = hole_in_rock(length, rock);
  std::vector<Line> lines = box_lines({{0, 0}, length});
  if (outline.hole)
    for (const Line& line : box_lines(*outline.hole))
      if (!on_a_side(line, length)) lines.push_back(line);
  const double tolerance = 1e-7 * std::max(length[0], length[1]);
  outline.tie = tolerance;
  for (const Form& hole : rock.holes) {
    outline.holes.push_back(polygon_of(hole, size));
    for (const Line& line : lines_around(outline.holes.back()))
      if (!on_a_side(line, length)) lines.push_back(line);
  }
  const std::vector<Line> rims = lines;
  for (const Form& border : rock.borders)
    for (const Line& line : lines_around(polygon_of(border, size)))
      if (!on_a_side(line, length)) lines.push_back(line);
  for (const Notch& notch : rock.notches)
    lines.push_back({attached(notch.from, rims, size), attached(notch.to, rims, size), true});

  const OrderedRectangle rock_box{{0, 0}, length};
  std::vector<Outline::Edge> pieces;
  for (const Line& line : lines) {
    const auto stops = meetings(line, lines, tolerance);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const Point middle = line.at((stops[i].t + stops[i + 1].t) / 2);
      const bool in_hole = outline.hole && outline.hole->contains(middle, line.notch ? -tolerance : 0);
      const bool rim_in_hole = outline.hole && on_a_side(line, length) && outline.hole->contains(middle, tolerance);
      const bool cut = outline.in_holes(on_a_side(line, length) ? moved_inside(middle, length, 4 * tolerance) : middle);
      if (in_hole || rim_in_hole || cut || !rock_box.contains(middle, tolerance)) continue;
      if (distance(stops[i].point, stops[i + 1].point) < tolerance) continue;
      const int a = point_number(outline, stops[i].point, tolerance);
      const int b = point_number(outline, stops[i + 1].point, tolerance);
      const bool known = std::any_of(pieces.begin(), pieces.end(), [a, b](const auto& e) {
        return (e.a == a && e.b == b) || (e.a == b && e.b == a);
      });
      if (a != b && !known) pieces.push_back({a, b, line.notch});
    }
  }
  for (const Point corner : {Point{0, 0}, Point{length[0], 0}, length, Point{0, length[1]}})
    point_number(outline, corner, tolerance);  // also where the hole cuts it away: they span the triangulation
  for (const auto& piece : pieces) divide(outline, piece.a, piece.b, piece.notch, size);
  return outline;
}

}  // namespace vug::detail
