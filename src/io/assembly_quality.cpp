#include "io/assembly_quality.hpp"

#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

namespace vug {

namespace {

struct Side {
  int low, high;  // vertex numbers
  bool forward;   // run through from low to high
  int triangle;
};

// All sides of all triangles, sorted so that those of one edge are next to each other.
std::vector<Side> sorted_sides(const Assembly& assembly) {
  std::vector<Side> sides;
  sides.reserve(3 * assembly.triangles.size());
  for (int t = 0; t < static_cast<int>(assembly.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = assembly.triangles[t][k];
      const int b = assembly.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), a < b, t});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

int root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

double length(const Assembly& assembly, int a, int b) {
  const auto& p = assembly.vertices[a];
  const auto& q = assembly.vertices[b];
  return std::hypot(q[0] - p[0], q[1] - p[1]);
}

std::array<double, 2> centre(const Assembly& assembly, const std::array<int, 3>& triangle) {
  std::array<double, 2> mean{};
  for (const int v : triangle)
    for (int axis = 0; axis < 2; ++axis) mean[axis] += assembly.vertices[v][axis] / 3;
  return mean;
}

double signed_area(const Assembly& assembly, const std::array<int, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const auto& p = assembly.vertices[a];
  const auto& q = assembly.vertices[b];
  const auto& r = assembly.vertices[c];
  return 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
}

// Smallest angle in degrees: opposite the shortest side, by the law of cosines.
double smallest_angle(const Assembly& assembly, const std::array<int, 3>& triangle) {
  std::array<double, 3> side{};
  for (int k = 0; k < 3; ++k) side[k] = length(assembly, triangle[k], triangle[(k + 1) % 3]);
  std::sort(side.begin(), side.end());
  if (side[1] == 0) return 0;
  const double cosine = (side[1] * side[1] + side[2] * side[2] - side[0] * side[0]) / (2 * side[1] * side[2]);
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// `parent`: of each triangle, towards one that stands for its piece.
void measure_pieces(const Assembly& assembly, std::vector<int>& parent, AssemblyQuality& quality) {
  std::vector<int> triangles(parent.size(), 0);
  for (int t = 0; t < static_cast<int>(parent.size()); ++t) ++triangles[root(parent, t)];
  int fewest = 0;
  for (std::size_t t = 0; t < parent.size(); ++t) {
    if (triangles[t] == 0) continue;
    ++quality.islands;
    if (fewest > 0 && triangles[t] >= fewest) continue;
    fewest = triangles[t];
    quality.apart = centre(assembly, assembly.triangles[t]);
  }
}

void measure_edges(const Assembly& assembly, AssemblyQuality& quality) {
  const auto sides = sorted_sides(assembly);
  std::vector<int> parent(assembly.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  int edges = 0;
  for (auto first = sides.begin(); first != sides.end();) {
    const auto last = std::find_if(first, sides.end(),
                                   [&first](const Side& s) { return s.low != first->low || s.high != first->high; });
    ++edges;
    quality.mean_edge += length(assembly, first->low, first->high);
    for (auto other = first + 1; other < last; ++other)
      parent[root(parent, other->triangle)] = root(parent, first->triangle);
    const auto uses = last - first;
    if (uses > 2 || (uses == 2 && first->forward == (first + 1)->forward)) {
      ++quality.overused_edges;
      quality.overused = assembly.vertices[first->low];
    }
    first = last;
  }
  if (edges > 0) quality.mean_edge /= edges;
  measure_pieces(assembly, parent, quality);
}

}  // namespace

AssemblyQuality assembly_quality(const Assembly& assembly) {
  AssemblyQuality quality;
  if (assembly.triangles.empty()) return quality;
  quality.min_angle = 60;
  double smallest = signed_area(assembly, assembly.triangles.front());
  for (const auto& triangle : assembly.triangles) {
    const double area = signed_area(assembly, triangle), angle = smallest_angle(assembly, triangle);
    quality.area += area;
    if (area <= smallest) quality.smallest = centre(assembly, triangle);
    if (angle <= quality.min_angle) quality.sharpest = centre(assembly, triangle);
    smallest = std::min(smallest, area);
    quality.min_angle = std::min(quality.min_angle, angle);
    if (area > 0) continue;
    ++quality.inverted_triangles;
    quality.inverted = centre(assembly, triangle);
  }
  quality.min_area_share = smallest * static_cast<double>(assembly.triangles.size()) / quality.area;
  measure_edges(assembly, quality);
  return quality;
}

std::optional<Flaw> flaw_of(const AssemblyQuality& quality, const AssemblyLimits& limits) {
  if (quality.islands == 0) return Flaw{"the rock has no triangles", {}};
  if (quality.inverted_triangles > 0)
    return Flaw{fmt::format("{} triangles are clockwise or have no area", quality.inverted_triangles),
                quality.inverted};
  if (quality.overused_edges > 0)
    return Flaw{
        fmt::format("{} edges belong to more than two triangles, or triangles overlap there", quality.overused_edges),
        quality.overused};
  if (quality.islands > limits.islands)
    return Flaw{fmt::format("the rock falls into {} pieces that share no edge (allowed: {}); are vertices doubled? "
                            "Bodies that are to separate share edges in the group \"crack\"",
                            quality.islands, limits.islands),
                quality.apart};
  if (!(quality.min_angle >= limits.min_angle))
    return Flaw{fmt::format("the smallest angle of a triangle is {:.3g} degrees, at least {:g} is needed",
                            quality.min_angle, limits.min_angle),
                quality.sharpest};
  if (!(quality.min_area_share >= limits.min_area_share))
    return Flaw{fmt::format("the smallest triangle has {:.3g} of the mean area, at least {:.3g} is needed",
                            quality.min_area_share, limits.min_area_share),
                quality.smallest};
  return std::nullopt;
}

void require_usable(const Assembly& assembly, const AssemblyLimits& limits, const std::string& where) {
  const std::optional<Flaw> flaw = flaw_of(assembly_quality(assembly), limits);
  if (!flaw) return;
  const std::string at = flaw->at ? fmt::format(" (at x = {:g} m, y = {:g} m)", (*flaw->at)[0], (*flaw->at)[1]) : "";
  throw InputError(where + ": " + flaw->what + at);
}

}  // namespace vug
