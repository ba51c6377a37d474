#include "coupling/rock_pathways.hpp"

#include "base/require.hpp"
#include "coupling/initial_pathways.hpp"
#include "coupling/pathway_widths.hpp"
#include "dem/edges.hpp"
#include "dem/particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

double distance(const std::array<double, 2>& p, const Notch& notch) {
  const double dx = notch.to[0] - notch.from[0], dy = notch.to[1] - notch.from[1];
  const double along = ((p[0] - notch.from[0]) * dx + (p[1] - notch.from[1]) * dy) / (dx * dx + dy * dy);
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p[0] - notch.from[0] - t * dx, p[1] - notch.from[1] - t * dy);
}

/// Width of the bonds that are cracks from the start, in cells; 0 for all other bonds. A crack of the generator has the
/// width of the notch nearest to its middle (because ends are extended to the hole). A crack of a mesh has that of the
/// notch on which it lies, otherwise that of pathways. Where notches lie on each other, the widest counts.
std::vector<double> crack_widths(const Scene& scene, const Assembly& assembly, const BondEdges& bonds) {
  const RockSection& section = *scene.rock;
  const double slack = 1e-7 * (scene.lattice.length_x + scene.lattice.length_y);
  const PathwayWidths widths(scene);
  std::vector<double> of_bonds(bonds.vertices.size(), 0);
  std::vector<bool> found(section.notches.size(), false);
  for (const auto& crack : assembly.initial_cracks) {
    const auto bond = bonds.number.find(ordered(crack[0], crack[1]));
    if (bond == bonds.number.end()) continue;
    const auto &p = assembly.vertices[crack[0]], &q = assembly.vertices[crack[1]];
    const std::array<double, 2> middle{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
    double nearest = section.mesh ? slack : std::numeric_limits<double>::infinity();
    for (const Notch& notch : section.notches) nearest = std::min(nearest, distance(middle, notch));
    double widest = -1;
    for (std::size_t n = 0; n < found.size(); ++n) {
      if (distance(middle, section.notches[n]) > nearest + slack) continue;
      widest = std::max(widest, widths.of(section.notches[n]));
      found[n] = true;
    }
    of_bonds[bond->second] = std::max(of_bonds[bond->second], widest < 0 ? widths.of_pathways : widest);
  }
  for (std::size_t n = 0; n < found.size(); ++n)
    if (section.mesh && !found[n])
      throw InputError(fmt::format("{}: rock.notches.{}: no line of the group \"crack\" or \"notch\" of {} lies on it",
                                   scene.path, section.notches[n].entry, *section.mesh));
  return of_bonds;
}

/// Area that pathways of `width` (bond, cells) take of the rock, cells^2.
double area_of(const std::vector<bool>& open, const BondEdges& bonds, const std::vector<double>& width,
               double spacing) {
  double area = 0;
  for (std::size_t b = 0; b < open.size(); ++b)
    if (open[b]) area += width[b] * bonds.length[b] / spacing;
  return area;
}

double area_of(const Assembly& assembly, double spacing) {
  double area = 0;
  for (std::size_t t = 0; t < assembly.triangles.size(); ++t) area += triangle_of(assembly, static_cast<int>(t)).area();
  return area / (spacing * spacing);
}

}  // namespace

BondEdges bond_edges(const Assembly& assembly) {
  BondEdges bonds;
  for (const Edge& edge : find_edges(assembly)) {
    if (edge.triangle[1] < 0) continue;
    const auto& p = assembly.vertices[edge.vertex[0]];
    const auto& q = assembly.vertices[edge.vertex[1]];
    const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
    double spacing = 0;
    for (const int t : edge.triangle) {
      std::array<double, 2> centroid{0, 0};
      for (const int v : assembly.triangles[t])
        for (int axis = 0; axis < 2; ++axis) centroid[axis] += assembly.vertices[v][axis] / 3;
      spacing += std::abs((centroid[0] - p[0]) * (q[1] - p[1]) - (centroid[1] - p[1]) * (q[0] - p[0])) / length;
    }
    const VertexPair pair = ordered(edge.vertex[0], edge.vertex[1]);
    bonds.number[pair] = static_cast<int>(bonds.vertices.size());
    bonds.vertices.push_back(pair);
    bonds.length.push_back(length);
    bonds.spacing.push_back(spacing);
  }
  return bonds;
}

std::vector<std::vector<StripNode>> bond_strips(const Scene& scene, const Lattice& lattice, const Assembly& assembly,
                                                const BondEdges& bonds, const RockRaster& raster,
                                                const std::vector<double>& width) {
  const PathwayWidths widths(scene);
  std::vector<std::vector<StripNode>> strips(bonds.vertices.size());
  for (std::size_t b = 0; b < strips.size(); ++b) {
    const double aperture = widths.strip(width[b]);
    if (aperture <= 0) continue;
    const auto [p, q] = bonds.vertices[b];
    strips[b] = strip_nodes(assembly.vertices[p], assembly.vertices[q], aperture, lattice, scene.lattice.spacing);
    std::erase_if(strips[b], [&](const StripNode& strip) { return raster.owner[strip.node] < 0; });
  }
  return strips;
}

namespace {

/// The bonds that carry pathways of `width` (bond, cells), including those that are `fixed`.
std::vector<bool> pathway_bonds(const Scene& scene, const Lattice& lattice, const Assembly& assembly,
                                const BondEdges& bonds, const RockRaster& raster, const std::vector<double>& width,
                                const std::vector<bool>& fixed) {
  const RockSection& section = *scene.rock;
  const double spacing = scene.lattice.spacing;
  if (section.pathway_width)
    return choose_pathways(assembly, fixed, section.porosity * area_of(assembly, spacing), section.seed,
                           [&](const auto& open) { return area_of(open, bonds, width, spacing); });
  std::vector<std::vector<int>> strips;
  for (const auto& strip : bond_strips(scene, lattice, assembly, bonds, raster, width)) {
    std::vector<int>& nodes = strips.emplace_back();
    for (const StripNode& entry : strip) nodes.push_back(entry.node);
  }
  const auto rock_nodes = std::count_if(raster.owner.begin(), raster.owner.end(), [](int owner) { return owner >= 0; });
  return choose_pathways(assembly, fixed, std::round(section.porosity * static_cast<double>(rock_nodes)), section.seed,
                         [&](const auto& open) { return count_nodes(open, strips); });
}

}  // namespace

std::vector<double> initial_widths(const Scene& scene, const Lattice& lattice, const Assembly& assembly,
                                   const BondEdges& bonds, const RockRaster& raster) {
  std::vector<double> width = crack_widths(scene, assembly, bonds);
  if (scene.rock->porosity <= 0) return width;
  std::vector<bool> fixed(width.size());
  std::vector<double> wide = width;
  for (std::size_t b = 0; b < width.size(); ++b) {
    fixed[b] = width[b] > 0;
    if (!fixed[b]) wide[b] = PathwayWidths(scene).of_pathways;
  }
  const std::vector<bool> chosen = pathway_bonds(scene, lattice, assembly, bonds, raster, wide, fixed);
  for (std::size_t b = 0; b < width.size(); ++b)
    if (chosen[b]) width[b] = wide[b];
  return width;
}

}  // namespace vug
