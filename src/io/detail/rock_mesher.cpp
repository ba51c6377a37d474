#include "io/detail/rock_mesher.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace vug::detail {

namespace {

constexpr double spacing_per_edge = 0.787;  // distance between points over the mean edge that results (measured)
constexpr int smoothing_sweeps = 6;

double edge_length(const Outline& outline, const Outline::Edge& edge) {
  return distance(outline.points[edge.a], outline.points[edge.b]);
}

/// An edge of the outline that the triangles do not have.
std::optional<Outline::Edge> missing_edge(const Outline& outline, const std::vector<std::array<int, 3>>& triangles) {
  std::set<std::array<int, 2>> edges;
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k) edges.insert({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
  const auto missing = std::find_if(outline.edges.begin(), outline.edges.end(), [&edges](const Outline::Edge& e) {
    return !edges.contains({std::min(e.a, e.b), std::max(e.a, e.b)});
  });
  return missing == outline.edges.end() ? std::nullopt : std::optional(*missing);
}

}  // namespace

RockMesher::RockMesher(Point length_, const RockSection& rock)
    : length(length_),
      size(length_, rock),
      outline(rock_outline(length_, rock, size)),
      grid_(length_),
      limits_{20, 0.2 / (rock.grading * rock.grading), 1} {}

RockMesher::RockMesher(DiscOutline disc, const RockSection& rock)
    : length(disc.length),
      size(length, rock),
      outline(std::move(disc.outline)),
      grid_(length),
      limits_{20, 0.2 / (rock.grading * rock.grading), 1} {}

bool RockMesher::in_disc(Point p) const {
  return std::all_of(outline.edges.begin(), outline.edges.end(), [&](const Outline::Edge& edge) {
    const Point &a = outline.points[edge.a], &b = outline.points[edge.b];
    return (b[0] - a[0]) * (p[1] - a[1]) > (b[1] - a[1]) * (p[0] - a[0]);
  });
}

bool RockMesher::in_rock(Point p) const {
  return p[0] > 0 && p[1] > 0 && p[0] < length[0] && p[1] < length[1] &&
         !(outline.hole && outline.hole->contains(p, 1e-9 * length[0])) && !outline.in_holes(p) &&
         (!outline.round || in_disc(p));
}

KeepOut RockMesher::edge_discs(double factor) const {
  double longest = size.largest();
  for (const auto& edge : outline.edges) longest = std::max(longest, edge_length(outline, edge));
  KeepOut keep_out(length, longest);
  for (const auto& edge : outline.edges) {
    const Point& a = outline.points[edge.a];
    const Point& b = outline.points[edge.b];
    keep_out.add_disc({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}, factor * edge_length(outline, edge));
  }
  return keep_out;
}

std::vector<Point> RockMesher::scatter(std::uint64_t stream) const {
  auto keep_out = edge_discs(0.6);
  const auto spacing = [this](Point p) { return spacing_per_edge * size(p); };
  for (const Point& p : outline.points) keep_out.add_point(p, spacing(p));
  auto points = outline.points;
  fill_with_points(points, keep_out, spacing, [this](Point p) { return in_rock(p); }, {stream});
  return points;
}

// Laplace smoothing: every free point moves to the mean of its neighbours, one after the other, unless that is inside
// the disc of an edge.
void RockMesher::smooth(std::vector<Point>& points, const Triangles& triangles) const {
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
Assembly RockMesher::assemble(const std::vector<Point>& points, const Triangles& triangles) const {
  Triangles kept;
  std::set<int> used;
  const auto is_corner = [this](int point) { return outline.round && point < 4; };
  for (const auto& t : triangles) {
    const Point centre{(points[t[0]][0] + points[t[1]][0] + points[t[2]][0]) / 3,
                       (points[t[0]][1] + points[t[1]][1] + points[t[2]][1]) / 3};
    if (in_hole(centre) || std::any_of(t.begin(), t.end(), is_corner)) continue;
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

std::variant<Assembly, Flaw> RockMesher::attempt(std::uint64_t stream) const {
  auto points = scatter(stream);
  auto triangles = delaunay(grid_, points);
  for (int sweep = 0; sweep < smoothing_sweeps; ++sweep) {
    smooth(points, triangles);
    triangles = delaunay(grid_, points);
  }
  if (const auto edge = missing_edge(outline, triangles)) {
    const Point &a = outline.points[edge->a], &b = outline.points[edge->b];
    return Flaw{"no triangle fits to an edge of the outline", Point{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}};
  }
  auto assembly = assemble(points, triangles);
  const auto quality = assembly_quality(assembly);
  const auto found = flaw_of(quality, limits_);
  if (!found) return assembly;
  if (quality.islands > limits_.islands)
    return Flaw{fmt::format("the shapes cut the rock into {} pieces, one", quality.islands), quality.apart};
  return *found;
}

}  // namespace vug::detail
