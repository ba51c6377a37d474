#include "io/rock_generator.hpp"

#include "base/require.hpp"
#include "io/assembly_quality.hpp"
#include "io/detail/delaunay.hpp"
#include "io/detail/disc_outline.hpp"
#include "io/detail/poisson_disc.hpp"
#include "io/detail/rock_outline.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace vug {

namespace {

using detail::Outline;
using detail::Point;
using Triangles = std::vector<std::array<int, 3>>;

constexpr double spacing_per_edge = 0.787;  // distance between points over the mean edge that results (measured)
constexpr int smoothing_sweeps = 6;
constexpr int attempts = 8;

/// What stays the same between several attempts to make a mesh.
struct Mesher {
  Point length;
  detail::IntegerGrid grid;
  detail::ElementSize size;
  Outline outline;

  Mesher(Point length_, const RockSection& rock)
      : length(length_), grid(length_), size(length_, rock), outline(detail::rock_outline(length_, rock, size)) {}
  Mesher(detail::DiscOutline disc, const RockSection& rock)
      : length(disc.length), grid(length), size(length, rock), outline(std::move(disc.outline)) {}

  bool in_hole(Point p) const { return (outline.hole && outline.hole->contains(p, 0)) || outline.in_holes(p); }
  bool in_disc(Point p) const {
    return std::all_of(outline.edges.begin(), outline.edges.end(), [&](const Outline::Edge& edge) {
      const Point &a = outline.points[edge.a], &b = outline.points[edge.b];
      return (b[0] - a[0]) * (p[1] - a[1]) > (b[1] - a[1]) * (p[0] - a[0]);
    });
  }
  bool is_corner(int point) const { return outline.round && point < 4; }
  bool in_rock(Point p) const {
    return p[0] > 0 && p[1] > 0 && p[0] < length[0] && p[1] < length[1] &&
           !(outline.hole && outline.hole->contains(p, 1e-9 * length[0])) && !outline.in_holes(p) &&
           (!outline.round || in_disc(p));
  }
  // Discs around the edges of the outline; when they stay empty, these edges are Delaunay.
  detail::KeepOut edge_discs(double factor) const;
  std::vector<Point> scatter(std::uint64_t stream) const;
  void smooth(std::vector<Point>& points, const Triangles& triangles) const;
  Assembly assemble(const std::vector<Point>& points, const Triangles& triangles) const;
};

double edge_length(const Outline& outline, const Outline::Edge& edge) {
  return detail::distance(outline.points[edge.a], outline.points[edge.b]);
}

detail::KeepOut Mesher::edge_discs(double factor) const {
  double longest = size.largest();
  for (const auto& edge : outline.edges) longest = std::max(longest, edge_length(outline, edge));
  detail::KeepOut keep_out(length, longest);
  for (const auto& edge : outline.edges) {
    const Point& a = outline.points[edge.a];
    const Point& b = outline.points[edge.b];
    keep_out.add_disc({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}, factor * edge_length(outline, edge));
  }
  return keep_out;
}

std::vector<Point> Mesher::scatter(std::uint64_t stream) const {
  auto keep_out = edge_discs(0.6);
  const auto spacing = [this](Point p) { return spacing_per_edge * size(p); };
  for (const Point& p : outline.points) keep_out.add_point(p, spacing(p));
  auto points = outline.points;
  detail::fill_with_points(points, keep_out, spacing, [this](Point p) { return in_rock(p); }, {stream});
  return points;
}

// Laplace smoothing: every free point moves to the mean of its neighbours, one after the other, unless that is inside
// the disc of an edge.
void Mesher::smooth(std::vector<Point>& points, const Triangles& triangles) const {
  const auto discs = edge_discs(0.5);
  std::vector<std::vector<int>> neighbours(points.size());
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k) neighbours[t[k]].push_back(t[(k + 1) % 3]);  // a closed fan names each once
  for (std::size_t i = outline.points.size(); i < points.size(); ++i) {
    Point mean{0, 0};
    for (const int n : neighbours[i])
      for (int axis = 0; axis < 2; ++axis) mean[axis] += points[n][axis] / static_cast<double>(neighbours[i].size());
    if (in_rock(mean) && discs.allows(mean, 0)) points[i] = mean;
  }
}

// Drops the triangles of the hole and the unused points, and numbers points row by row, so that neighbours are close in
// memory.
Assembly Mesher::assemble(const std::vector<Point>& points, const Triangles& triangles) const {
  Triangles kept;
  std::set<int> used;
  for (const auto& t : triangles) {
    const Point centre{(points[t[0]][0] + points[t[1]][0] + points[t[2]][0]) / 3,
                       (points[t[0]][1] + points[t[1]][1] + points[t[2]][1]) / 3};
    if (in_hole(centre) || std::any_of(t.begin(), t.end(), [this](int p) { return is_corner(p); })) continue;
    kept.push_back(t);
    used.insert(t.begin(), t.end());
  }
  std::vector<int> order(used.begin(), used.end());
  const double row = 2 * size.largest();
  const auto key = [&](int i) { return std::tuple(std::floor(points[i][1] / row), points[i][0], points[i][1]); };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return key(i) < key(j); });

  Assembly assembly;
  std::vector<int> number(points.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[order[i]] = static_cast<int>(i);
    assembly.vertices.push_back(points[order[i]]);
  }
  for (const auto& t : kept) {
    std::array<int, 3> renamed{number[t[0]], number[t[1]], number[t[2]]};
    std::rotate(renamed.begin(), std::min_element(renamed.begin(), renamed.end()), renamed.end());
    assembly.triangles.push_back(renamed);
  }
  std::sort(assembly.triangles.begin(), assembly.triangles.end());
  for (const auto& edge : outline.edges)
    if (edge.notch)
      assembly.initial_cracks.push_back(
          {std::min(number[edge.a], number[edge.b]), std::max(number[edge.a], number[edge.b])});
  return assembly;
}

/// An edge of the outline that the triangles do not have.
std::optional<Outline::Edge> missing_edge(const Outline& outline, const Triangles& triangles) {
  std::set<std::array<int, 2>> edges;
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k) edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
  const auto missing = std::find_if(outline.edges.begin(), outline.edges.end(), [&edges](const Outline::Edge& e) {
    return !edges.contains({std::min(e.a, e.b), std::max(e.a, e.b)});
  });
  return missing == outline.edges.end() ? std::nullopt : std::optional(*missing);
}

/// The shapes whose outline is within a distance of a place, the nearest first.
std::vector<std::string> shapes_near(const Outline& outline, Point place, double reach) {
  std::map<std::string, double> nearest;
  for (const auto& edge : outline.edges) {
    const double d = detail::distance(detail::Line{outline.points[edge.a], outline.points[edge.b]}, place);
    if (d > reach) continue;
    const auto known = nearest.try_emplace(outline.shapes[edge.shape], d).first;
    known->second = std::min(known->second, d);
  }
  std::vector<std::string> shapes;
  for (const auto& [shape, d] : nearest) shapes.push_back(shape);
  std::stable_sort(shapes.begin(), shapes.end(),
                   [&](const auto& a, const auto& b) { return nearest.at(a) < nearest.at(b); });
  return shapes;
}

/// What to change at a place, beside the shapes that are there.
std::string advice(const std::vector<std::string>& shapes, const RockSection& rock) {
  std::string smaller = fmt::format("lower rock.element_size (now {:g} m)", rock.element_size);
  if (rock.grading > 1) smaller += fmt::format(" or rock.grading (now {:g})", rock.grading);
  if (shapes.empty()) return ", away from all shapes; change rock.seed, or " + smaller;
  if (shapes.size() == 1)
    return fmt::format(", at {}; make its narrow parts and sharp corners wider, or {}", shapes[0], smaller);
  return fmt::format(", between {}; move them apart, let them cross or meet at a wider angle, or {}",
                     fmt::join(shapes, " and "), smaller);
}

/// One line: what is wrong where, which shapes are there, and what to change.
InputError refusal(const Mesher& mesher, const RockSection& rock, const Flaw& flaw) {
  const std::string why = fmt::format("rock: no usable mesh after {} attempts: {}", attempts, flaw.what);
  if (!flaw.at) return InputError(why + "; make the holes smaller");
  const Point at = *flaw.at;
  return InputError(fmt::format("{} at x = {:.4g} m, y = {:.4g} m{}", why, at[0], at[1],
                                advice(shapes_near(mesher.outline, at, 2 * mesher.size(at)), rock)));
}

Assembly triangulate(const Mesher& mesher, const RockSection& rock) {
  const AssemblyLimits limits{20, 0.2 / (rock.grading * rock.grading), 1};
  Flaw flaw;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    auto points = mesher.scatter(CounterRandom{rock.seed * attempts + attempt}.next());
    auto triangles = detail::delaunay(mesher.grid, points);
    for (int sweep = 0; sweep < smoothing_sweeps; ++sweep) {
      mesher.smooth(points, triangles);
      triangles = detail::delaunay(mesher.grid, points);
    }
    if (const auto edge = missing_edge(mesher.outline, triangles)) {
      const Point &a = mesher.outline.points[edge->a], &b = mesher.outline.points[edge->b];
      flaw = {"no triangle fits to an edge of the outline", Point{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}};
      continue;
    }
    auto assembly = mesher.assemble(points, triangles);
    const auto quality = assembly_quality(assembly);
    const auto found = flaw_of(quality, limits);
    if (!found) return assembly;
    flaw = *found;
    if (quality.islands > limits.islands)
      flaw = {fmt::format("the shapes cut the rock into {} pieces, one", quality.islands), quality.apart};
  }
  throw refusal(mesher, rock, flaw);
}

}  // namespace

Assembly generate_rock(double length_x, double length_y, const RockSection& rock) {
  if (!(rock.element_size > 0) || !(rock.grading >= 1))
    throw InputError("rock: element_size must be positive and grading at least 1");
  if (!(rock.element_size < 0.5 * std::min(length_x, length_y)))
    throw InputError(
        fmt::format("rock.element_size = {:g} m is more than half the rock's shorter side", rock.element_size));
  return triangulate(Mesher(Point{length_x, length_y}, rock), rock);
}

Assembly generate_disc(double diameter, double flat_width, const RockSection& rock) {
  if (!(rock.element_size > 0) || !(rock.element_size <= diameter / 5))
    throw InputError(fmt::format(
        "rock.element_size = {:g} m must be positive and at most a fifth of the disc's diameter", rock.element_size));
  return triangulate(Mesher(detail::disc_outline(diameter, flat_width, rock.element_size), rock), rock);
}

}  // namespace vug
