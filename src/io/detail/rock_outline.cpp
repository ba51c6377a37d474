#include "io/detail/rock_outline.hpp"

#include "base/require.hpp"
#include "io/detail/circle_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::detail {

namespace {

std::vector<Line> box_lines(const OrderedRectangle& box) {
  return lines_around({box.low, {box.high[0], box.low[1]}, box.high, {box.low[0], box.high[1]}});
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

/// What a case draws into the rock, as it is: straight lines, and circles that are no polygons yet.
struct Drawing {
  std::vector<Line> lines;
  std::vector<Disc> circles;

  void add(const Form& form) {
    if (const auto* disc = std::get_if<Disc>(&form)) {
      circles.push_back(*disc);
    } else {
      for (const Line& line : lines_around(outline_of(form, 1))) lines.push_back(line);
    }
  }
};

// Extends a notch that ends just short of a side or of a hole up to it; the gap would make very thin triangles.
Point attached(Point end, const Drawing& rims, const ElementSize& size) {
  Point best = end;
  double closest = 0.5 * size(end);
  const auto consider = [&](Point foot) {
    if (distance(foot, end) >= closest) return;
    closest = distance(foot, end);
    best = foot;
  };
  for (const Line& line : rims.lines) consider(line.at(nearest(line, end)));
  for (const auto& [centre, radius] : rims.circles)
    if (const double from_centre = distance(centre, end); from_centre > 0) {
      const double scale = radius / from_centre;
      consider({centre[0] + scale * (end[0] - centre[0]), centre[1] + scale * (end[1] - centre[1])});
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
      if (distance(line, end) < tolerance) found.push_back({nearest(line, end), end});
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

// Adds points to an edge that divide the integral of 1 / size into equal parts.
void divide(Outline& outline, const Outline::Edge& edge, const ElementSize& size) {
  constexpr int samples = 1000;
  const Line line{outline.points[edge.a], outline.points[edge.b]};
  const double step = distance(line.from, line.to) / samples;
  std::vector<double> count(samples + 1, 0.0);
  for (int i = 0; i < samples; ++i) count[i + 1] = count[i] + step / size(line.at((i + 0.5) / samples));
  const int parts = std::max(1, static_cast<int>(std::ceil(count[samples] - 0.25)));
  int last = edge.a;
  for (int part = 1, i = 0; part < parts; ++part) {
    const double wanted = count[samples] * part / parts;
    while (count[i + 1] < wanted) ++i;
    const double t = (i + (wanted - count[i]) / (count[i + 1] - count[i])) / samples;
    outline.points.push_back(line.at(t));
    const int next = static_cast<int>(outline.points.size()) - 1;
    outline.edges.push_back({last, next, edge.notch, edge.shape});
    last = next;
  }
  outline.edges.push_back({last, edge.b, edge.notch, edge.shape});
}

/// The corners of a form. Those of a disc are about one local element size apart, and where others cross it.
Polygon corners_of(const Form& form, const Drawing& others, const ElementSize& size, double tolerance) {
  const auto* disc = std::get_if<Disc>(&form);
  if (!disc) return {outline_of(form, 1)};
  std::vector<Point> at;
  for (const Line& line : others.lines)
    for (const Point& p : crossings(*disc, line, tolerance)) at.push_back(p);
  for (const Disc& other : others.circles)
    for (const Point& p : crossings(*disc, other, tolerance)) at.push_back(p);
  return {polygon_of(*disc, size({disc->centre[0] + disc->radius, disc->centre[1]}), at, tolerance)};
}

/// Everything that a case draws: the sides and the holes with what notches may be attached to, and then the rest.
Drawing drawing_of(Point length, const RockSection& rock, const std::optional<OrderedRectangle>& hole,
                   const ElementSize& size, std::vector<Line>& notches) {
  Drawing all;
  all.lines = box_lines({{0, 0}, length});
  if (hole)
    for (const Line& line : box_lines(*hole)) all.lines.push_back(line);
  for (const Form& form : rock.holes) all.add(form);
  for (const Notch& notch : rock.notches) {
    const auto goes_on = [&](Point end, Point Notch::*other_end) {
      return std::any_of(rock.notches.begin(), rock.notches.end(),
                         [&](const Notch& other) { return other.entry == notch.entry && other.*other_end == end; });
    };
    notches.push_back({goes_on(notch.from, &Notch::to) ? notch.from : attached(notch.from, all, size),
                       goes_on(notch.to, &Notch::from) ? notch.to : attached(notch.to, all, size), true});
  }
  for (const Form& form : rock.borders) all.add(form);
  all.lines.insert(all.lines.end(), notches.begin(), notches.end());
  return all;
}

/// The lines of the outline, circles as polygons, and the shapes that they belong to.
std::vector<Line> lines_of(Point length, const RockSection& rock, const ElementSize& size, Outline& outline) {
  std::vector<Line> lines;
  const auto add = [&](const std::string& shape, std::vector<Line> some) {
    for (Line& line : some) {
      line.shape = static_cast<int>(outline.shapes.size());
      if (!on_a_side(line, length)) lines.push_back(line);
    }
    outline.shapes.push_back(shape);
  };
  lines = box_lines({{0, 0}, length});
  for (std::size_t side = 0; side < lines.size(); ++side) lines[side].shape = static_cast<int>(side);
  outline.shapes = {"the bottom side", "the right side", "the top side", "the left side"};
  std::vector<Line> notches;
  const Drawing all = drawing_of(length, rock, outline.hole, size, notches);
  const auto polygon = [&](const Form& form) { return corners_of(form, all, size, outline.tie); };
  if (outline.hole) add("rock.hole", box_lines(*outline.hole));
  for (std::size_t h = 0; h < rock.holes.size(); ++h) {
    outline.holes.push_back(polygon(rock.holes[h]));
    add(fmt::format("rock.holes.{}", h), lines_around(outline.holes.back().points));
  }
  for (const Form& border : rock.borders) add("a mechanics.material", lines_around(polygon(border).points));
  for (std::size_t n = 0; n < notches.size(); ++n)
    add(fmt::format("rock.notches.{}", rock.notches[n].entry), {notches[n]});
  return lines;
}

/// Throws InputError for a notch of which nothing is left. `cracked`: the shapes of all edges of notches.
void require_notches(const RockSection& rock, const std::set<std::string>& cracked) {
  for (const Notch& notch : rock.notches)
    if (!cracked.contains(fmt::format("rock.notches.{}", notch.entry)))
      throw InputError(
          fmt::format("rock.notches.{}: nothing is left of it: it lies on a side or in a hole of the rock, or within "
                      "half an element of one, to which its ends are drawn; lower rock.element_size, or remove it",
                      notch.entry));
}

}  // namespace

bool Outline::in_holes(Point p) const {
  return std::any_of(holes.begin(), holes.end(),
                     [&](const Polygon& cut) { return holds(cut, p, 0) && distance_to_rim(cut, p) > tie; });
}

Outline rock_outline(Point length, const RockSection& rock, const ElementSize& size) {
  Outline outline;
  const double tolerance = 1e-7 * std::max(length[0], length[1]);
  outline.tie = tolerance;
  outline.hole = hole_in_rock(length, rock);
  const std::vector<Line> lines = lines_of(length, rock, size, outline);
  const int inner =
      4 + (outline.hole ? 1 : 0) + static_cast<int>(outline.holes.size());  // shapes before bound the rock
  const OrderedRectangle rock_box{{0, 0}, length};
  std::vector<Outline::Edge> pieces;
  std::set<std::string> cracked;
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
      if (a == b) continue;
      auto piece = std::find_if(pieces.begin(), pieces.end(),
                                [a, b](const auto& e) { return (e.a == a && e.b == b) || (e.a == b && e.b == a); });
      if (piece == pieces.end()) piece = pieces.insert(piece, {a, b, line.notch, line.shape});
      if (!line.notch || piece->shape < inner) continue;
      piece->notch = true;  // also where it follows the outline of a material
      cracked.insert(outline.shapes[line.shape]);
    }
  }
  require_notches(rock, cracked);
  for (const Point corner : {Point{0, 0}, Point{length[0], 0}, length, Point{0, length[1]}})
    point_number(outline, corner, tolerance);  // also where the hole cuts it away: they span the triangulation
  for (const auto& piece : pieces) divide(outline, piece, size);
  return outline;
}

}  // namespace vug::detail
