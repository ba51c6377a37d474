#include "coupling/rock_pathways.hpp"

#include "coupling/initial_pathways.hpp"
#include "dem/edges.hpp"
#include "kernels/base/host_and_device.hpp"
#include "kernels/base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug {

namespace {

/// The widths that a case gives, in cells.
struct Widths {
  bool cubic;                              ///< they are those of slots of any width, else rows of nodes
  double spacing, of_pathways, of_broken;  ///< m; cells: the last of a broken bond at least

  explicit Widths(const Scene& scene) : cubic(scene.rock->pathway_width.has_value()), spacing(scene.lattice.spacing) {
    const double in_metres = scene.rock->pathway_width.value_or(0);
    const DamageSection damage = scene.damage.value_or(DamageSection{});
    of_pathways = cubic ? in_metres / spacing : scene.rock->pathway_aperture;
    of_broken = cubic ? damage.minimum_width.value_or(in_metres) / spacing : damage.minimum_aperture;
    if (!cubic) return;
    require_width(scene, "rock.pathway_width", of_pathways);
    if (of_broken > 0) require_width(scene, "damage.minimum_width", of_broken);
    for (const Notch& notch : scene.rock->notches)
      if (notch.width.value_or(0) > 0)
        require_width(scene, fmt::format("rock.notches.{}.width", notch.entry).c_str(), of(notch));
  }
  double of(const Notch& notch) const {
    if (!cubic) return notch.aperture;
    return notch.width ? *notch.width / spacing : of_pathways;
  }
  /// A narrower one would close without a word.
  void require_width(const Scene& scene, const char* key, double width) const {
    constexpr double rounding = 1e-9;
    if (width < narrowest_slit * (1 - rounding))
      throw InputError(fmt::format("{}: {} is {:g} m, {:.2g} cells; pathways have {:g} cells or more", scene.path, key,
                                   width * spacing, width, narrowest_slit));
  }
  /// Aperture of the strip of nodes that a pathway opens.
  double strip(double width) const { return cubic ? strip_of_slot(width) : width; }
  /// Whether it needs drag to conduct as little as it should.
  bool drags(double width, double slope) const {
    return width > 0 && slit_resistance(cubic ? cubic_law(width) : slot_conductivity(width), slope) > 0;
  }
};

double distance(const std::array<double, 2>& p, const Notch& notch) {
  const double dx = notch.to[0] - notch.from[0], dy = notch.to[1] - notch.from[1];
  const double along = ((p[0] - notch.from[0]) * dx + (p[1] - notch.from[1]) * dy) / (dx * dx + dy * dy);
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p[0] - notch.from[0] - t * dx, p[1] - notch.from[1] - t * dy);
}

/// Width of the bonds that are cracks from the start, in cells; 0 for all other bonds. A crack of the generator has
/// that of the notch nearest to its middle (ends are led up to the hole), one of a mesh that of the notch it lies on or
/// the pathways'; of notches that lie on each other the widest counts.
std::vector<double> crack_widths(const Scene& scene, const Assembly& assembly, const BondEdges& bonds) {
  const RockSection& section = *scene.rock;
  const double slack = 1e-7 * (scene.lattice.length_x + scene.lattice.length_y);
  const Widths widths(scene);
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

/// What pathways of `width` (bond, cells) take of the rock, cells^2.
double area_of(const std::vector<bool>& open, const Assembly& assembly, const BondEdges& bonds,
               const std::vector<double>& width, double spacing) {
  double area = 0;
  for (std::size_t b = 0; b < open.size(); ++b) {
    if (!open[b]) continue;
    const auto &p = assembly.vertices[bonds.vertices[b][0]], &q = assembly.vertices[bonds.vertices[b][1]];
    area += width[b] * std::hypot(p[0] - q[0], p[1] - q[1]) / spacing;
  }
  return area;
}

double area_of(const Assembly& assembly, double spacing) {
  double area = 0;
  for (const auto& [a, b, c] : assembly.triangles) {
    const auto &p = assembly.vertices[a], &q = assembly.vertices[b], &r = assembly.vertices[c];
    area += ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2;
  }
  return area / (spacing * spacing);
}

/// Slope of each bond's edge to the axis that it follows more closely.
std::vector<double> slopes_of(const Assembly& assembly, const BondEdges& bonds) {
  std::vector<double> slopes;
  for (const auto& [p, q] : bonds.vertices) {
    const double x = std::abs(assembly.vertices[q][0] - assembly.vertices[p][0]);
    const double y = std::abs(assembly.vertices[q][1] - assembly.vertices[p][1]);
    slopes.push_back(std::min(x, y) / std::max(x, y));
  }
  return slopes;
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
    bonds.spacing.push_back(spacing);
  }
  return bonds;
}

std::vector<std::vector<StripNode>> bond_strips(const Scene& scene, const Lattice& lattice, const Assembly& assembly,
                                                const BondEdges& bonds, const RockRaster& raster,
                                                const std::vector<double>& width) {
  const Widths widths(scene);
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

/// The bonds that carry pathways of `width` (bond, cells), those that are `fixed` among them.
std::vector<bool> pathway_bonds(const Scene& scene, const Lattice& lattice, const Assembly& assembly,
                                const BondEdges& bonds, const RockRaster& raster, const std::vector<double>& width,
                                const std::vector<bool>& fixed) {
  const RockSection& section = *scene.rock;
  const double spacing = scene.lattice.spacing;
  if (section.pathway_width)
    return choose_pathways(assembly, fixed, section.porosity * area_of(assembly, spacing), section.seed,
                           [&](const auto& open) { return area_of(open, assembly, bonds, width, spacing); });
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
    if (!fixed[b]) wide[b] = Widths(scene).of_pathways;
  }
  const std::vector<bool> chosen = pathway_bonds(scene, lattice, assembly, bonds, raster, wide, fixed);
  for (std::size_t b = 0; b < width.size(); ++b)
    if (chosen[b]) width[b] = wide[b];
  return width;
}

PathwayNodes pathway_nodes(const Scene& scene, const Lattice& lattice, const Assembly& assembly, const BondEdges& bonds,
                           const RockRaster& raster, const std::vector<double>& closed,
                           const std::vector<bool>& solid) {
  const Widths widths(scene);
  std::vector<double> open(closed.size());
  for (std::size_t b = 0; b < open.size(); ++b)
    open[b] = std::max(
        {scene.damage->pathway_factor * bonds.spacing[b] / scene.lattice.spacing, widths.of_broken, closed[b]});
  const auto strips = bond_strips(scene, lattice, assembly, bonds, raster, open);
  const std::vector<double> slope = slopes_of(assembly, bonds);
  std::vector<bool> wanted = solid;
  for (std::size_t b = 0; b < strips.size(); ++b)
    if (widths.drags(closed[b], slope[b]))
      for (const StripNode& entry : strips[b]) wanted[entry.node] = true;
  std::map<int, std::vector<std::pair<int, double>>> of_node;  // bond and aperture, in order of bond
  for (std::size_t b = 0; b < strips.size(); ++b)
    for (const StripNode& entry : strips[b])
      if (wanted[entry.node]) of_node[entry.node].emplace_back(static_cast<int>(b), entry.aperture);
  std::vector<int> node, offset{0}, bond;
  std::vector<double> aperture;
  std::vector<std::vector<int>> of_triangle(assembly.triangles.size());
  for (const auto& [n, entries] : of_node) {
    of_triangle[raster.owner[n]].push_back(static_cast<int>(node.size()));
    node.push_back(lattice.node(n % lattice.nx, n / lattice.nx));
    for (const auto& [b, least] : entries) {
      bond.push_back(b);
      aperture.push_back(least);
    }
    offset.push_back(static_cast<int>(bond.size()));
  }
  std::vector<int> in_order, first{0};
  for (const std::vector<int>& candidates : of_triangle) {
    in_order.insert(in_order.end(), candidates.begin(), candidates.end());
    first.push_back(static_cast<int>(in_order.size()));
  }
  return {.node = to_device<IndexList>("vug::pathways::node", node),
          .offset = to_device<IndexList>("vug::pathways::offset", offset),
          .bond = to_device<IndexList>("vug::pathways::bond", bond),
          .least = to_device<ScalarField<double>>("vug::pathways::least_aperture", aperture),
          .closed = to_device<ScalarField<double>>("vug::pathways::closed", closed),
          .open = to_device<ScalarField<double>>("vug::pathways::open", open),
          .cubic = widths.cubic,
          .slope = to_device<ScalarField<double>>("vug::pathways::slope", slope),
          .in_order = to_device<IndexList>("vug::pathways::in_order", in_order),
          .first = to_device<IndexList>("vug::pathways::first", first)};
}

}  // namespace vug
