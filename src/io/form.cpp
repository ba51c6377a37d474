#include "io/form.hpp"

#include "io/detail/circle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vug {

namespace {

using Point = std::array<double, 2>;

std::vector<Point> circle(const Disc& disc, double edge) {
  constexpr double quarter = std::numbers::pi / 2;
  const int parts = std::max(2, static_cast<int>(std::lround(quarter * disc.radius / edge)));
  std::vector<Point> points;
  for (int turn = 0; turn < 4; ++turn)
    for (int i = 0; i < parts; ++i) {
      const Point unit =
          detail::turned(detail::on_circle(1, detail::tangent(detail::eighth_of_a_turn * i / parts)), turn);
      points.push_back({disc.centre[0] + disc.radius * unit[0], disc.centre[1] + disc.radius * unit[1]});
    }
  return points;
}

}  // namespace

bool holds(const Rectangle& r, const Point& p, double) {
  return p[0] >= std::min(r.from[0], r.to[0]) && p[0] < std::max(r.from[0], r.to[0]) &&
         p[1] >= std::min(r.from[1], r.to[1]) && p[1] < std::max(r.from[1], r.to[1]);
}

bool holds(const Disc& d, const Point& p, double tie) {
  return std::hypot(p[0] - d.centre[0], p[1] - d.centre[1]) <= d.radius + tie;
}

bool holds(const Polygon& polygon, const Point& p, double tie) {
  bool in = false;
  const auto& v = polygon.points;
  for (std::size_t a = 0, b = v.size() - 1; a < v.size(); b = a++)
    if ((v[a][1] > p[1]) != (v[b][1] > p[1]) &&
        p[0] < (v[b][0] - v[a][0]) * (p[1] - v[a][1]) / (v[b][1] - v[a][1]) + v[a][0] - tie)
      in = !in;
  return in;
}

bool holds(const Form& form, const Point& p, double tie) {
  return std::visit([&](const auto& one) { return holds(one, p, tie); }, form);
}

std::vector<Point> outline_of(const Form& form, double edge) {
  if (const auto* disc = std::get_if<Disc>(&form)) return circle(*disc, edge);
  if (const auto* polygon = std::get_if<Polygon>(&form)) return polygon->points;
  const auto& [a, c] = std::get<Rectangle>(form);
  return {a, {c[0], a[1]}, c, {a[0], c[1]}};
}

Box box_of(const Form& form) {
  if (const auto* rectangle = std::get_if<Rectangle>(&form)) {
    const auto [x0, x1] = std::minmax(rectangle->from[0], rectangle->to[0]);
    const auto [y0, y1] = std::minmax(rectangle->from[1], rectangle->to[1]);
    return {x0, y0, x1, y1};
  }
  if (const auto* disc = std::get_if<Disc>(&form)) {
    return {disc->centre[0] - disc->radius, disc->centre[1] - disc->radius, disc->centre[0] + disc->radius,
            disc->centre[1] + disc->radius};
  }
  const auto& points = std::get<Polygon>(form).points;
  Box box{points[0][0], points[0][1], points[0][0], points[0][1]};
  for (const auto& [x, y] : points) {
    box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x), std::max(box.y1, y)};
  }
  return box;
}

double outline_length(const Form& form) {
  if (const auto* disc = std::get_if<Disc>(&form)) return 2 * std::numbers::pi * disc->radius;
  const std::vector<Point> points = outline_of(form, 0);  // for a disc only the edge matters
  double length = 0;
  for (std::size_t a = 0, b = points.size() - 1; a < points.size(); b = a++)
    length += std::hypot(points[a][0] - points[b][0], points[a][1] - points[b][1]);
  return length;
}

}  // namespace vug
