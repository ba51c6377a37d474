#include "io/detail/circle_outline.hpp"

#include "io/detail/circle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vug::detail {

namespace {

/// A point on a circle, and how far around it that is, in turns that are not quite even (`turns`).
struct Corner {
  double turns;
  Point point;
};

Point on(const Disc& circle, Point unit) {
  return {circle.centre[0] + circle.radius * unit[0], circle.centre[1] + circle.radius * unit[1]};
}

}  // namespace

std::vector<Point> crossings(const Disc& circle, const Line& line, double tolerance) {
  std::vector<Point> found;
  for (const Point end : {line.from, line.to})
    if (std::abs(distance(end, circle.centre) - circle.radius) < tolerance) found.push_back(end);
  const double length = distance(line.from, line.to);
  if (length == 0) return found;
  const double dx = (line.to[0] - line.from[0]) / length, dy = (line.to[1] - line.from[1]) / length;
  const double wx = circle.centre[0] - line.from[0], wy = circle.centre[1] - line.from[1];
  const double foot = wx * dx + wy * dy, beside = wx * dy - wy * dx;
  const double square = circle.radius * circle.radius - beside * beside;
  if (std::abs(beside) > circle.radius + tolerance) return found;
  const double half = std::sqrt(std::max(square, 0.0));
  for (const double along : {foot - half, foot + half})
    if (along > tolerance && along < length - tolerance) found.push_back(line.at(along / length));
  return found;
}

std::vector<Point> crossings(const Disc& a, const Disc& b, double tolerance) {
  const double apart = distance(a.centre, b.centre);
  if (apart < tolerance) return {};
  // from the centre of a: `foot` along the line to the centre of b, `half` across it
  const double foot = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
  const double square = a.radius * a.radius - foot * foot;
  if (square <= 0) return {};
  const double half = std::sqrt(square);
  const double dx = (b.centre[0] - a.centre[0]) / apart, dy = (b.centre[1] - a.centre[1]) / apart;
  return {{a.centre[0] + foot * dx - half * dy, a.centre[1] + foot * dy + half * dx},
          {a.centre[0] + foot * dx + half * dy, a.centre[1] + foot * dy - half * dx}};
}

std::vector<Point> polygon_of(const Disc& circle, double edge, const std::vector<Point>& crossings, double tolerance) {
  if (crossings.empty()) return outline_of(circle, edge);
  std::vector<Corner> corners;
  for (const Point& p : crossings) {
    if (std::any_of(corners.begin(), corners.end(), [&](const Corner& c) { return distance(c.point, p) < tolerance; }))
      continue;
    corners.push_back({turns_of({p[0] - circle.centre[0], p[1] - circle.centre[1]}), p});
  }
  std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) { return a.turns < b.turns; });
  std::vector<Point> polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool last = i + 1 == corners.size();
    const double from = corners[i].turns, to = last ? corners.front().turns + 1 : corners[i + 1].turns;
    // no side so long that it would be divided off the circle
    const double sides = 2 * std::numbers::pi * circle.radius * (to - from) / edge - 0.25;
    const int parts = std::max(1, static_cast<int>(std::ceil(std::max(sides, 8 * (to - from)) - 1e-9)));
    polygon.push_back(corners[i].point);
    for (int part = 1; part < parts; ++part)
      polygon.push_back(on(circle, unit_at_turns(from + (to - from) * part / parts)));
  }
  return polygon;
}

}  // namespace vug::detail
