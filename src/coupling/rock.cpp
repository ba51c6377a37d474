#include "coupling/rock.hpp"

#include "coupling/geometry.hpp"
#include "coupling/initial_pathways.hpp"
#include "coupling/minerals.hpp"
#include "coupling/strip.hpp"
#include "dem/edges.hpp"
#include "io/mesh_reader.hpp"
#include "io/rock_generator.hpp"
#include "io/rock_regions.hpp"
#include "kernels/base/require.hpp"
#include "kernels/base/to_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace vug {

namespace {

using VertexPair = std::array<int, 2>;

VertexPair ordered(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The shared edges with what a pathway along them needs.
struct BondEdges {
  std::vector<VertexPair> vertices;  ///< (bond) low, high
  std::vector<double> spacing;       ///< (bond) distance of the two centroids across the edge, m
  std::map<VertexPair, int> number;
};

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

/// Sector of each node (see Rock), -1 where there is none.
std::vector<int> sector_of_nodes(const RockRaster& raster) {
  std::vector<int> sector(raster.owner.size(), -1);
  for (std::size_t n = 0; n < sector.size(); ++n)
    if (raster.owner[n] >= 0) sector[n] = 3 * raster.owner[n] + raster.edge[n];
  return sector;
}

SectorPairs sectors_of_bonds(const Assembly& assembly, const BondEdges& bonds) {
  const SectorPairs sectors("vug::rock_map::sectors_of_bond", bonds.vertices.size());
  const auto host = Kokkos::create_mirror_view(sectors);
  std::vector<int> found(bonds.vertices.size(), 0);
  for (std::size_t t = 0; t < assembly.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto& triangle = assembly.triangles[t];
      const auto bond = bonds.number.find(ordered(triangle[k], triangle[(k + 1) % 3]));
      if (bond != bonds.number.end()) host(bond->second, found[bond->second]++) = 3 * static_cast<int>(t) + k;
    }
  Kokkos::deep_copy(sectors, host);
  return sectors;
}

TriangleNeighbours neighbours_of_triangles(const Assembly& assembly) {
  const TriangleNeighbours neighbours("vug::rock::neighbours", assembly.triangles.size());
  const auto host = Kokkos::create_mirror_view(neighbours);
  Kokkos::deep_copy(host, -1);
  std::vector<int> found(assembly.triangles.size(), 0);
  for (const Edge& edge : find_edges(assembly)) {
    const auto [left, right] = edge.triangle;
    if (right < 0) continue;
    host(left, found[left]++) = right;
    host(right, found[right]++) = left;
  }
  Kokkos::deep_copy(neighbours, host);
  return neighbours;
}

/// The rock's nodes that a pathway of `aperture` (bond, cells) along each bond opens.
std::vector<std::vector<StripNode>> bond_strips(const Scene& scene, const Lattice& lattice, const Assembly& assembly,
                                                const BondEdges& bonds, const RockRaster& raster,
                                                const std::vector<double>& aperture) {
  std::vector<std::vector<StripNode>> strips(bonds.vertices.size());
  for (std::size_t b = 0; b < strips.size(); ++b) {
    if (aperture[b] <= 0) continue;
    const auto [p, q] = bonds.vertices[b];
    strips[b] = strip_nodes(assembly.vertices[p], assembly.vertices[q], aperture[b], lattice, scene.lattice.spacing);
    std::erase_if(strips[b], [&](const StripNode& strip) { return raster.owner[strip.node] < 0; });
  }
  return strips;
}

double distance(const std::array<double, 2>& p, const Notch& notch) {
  const double dx = notch.to[0] - notch.from[0], dy = notch.to[1] - notch.from[1];
  const double along = ((p[0] - notch.from[0]) * dx + (p[1] - notch.from[1]) * dy) / (dx * dx + dy * dy);
  const double t = std::clamp(along, 0.0, 1.0);
  return std::hypot(p[0] - notch.from[0] - t * dx, p[1] - notch.from[1] - t * dy);
}

/// Aperture of the bonds that are cracks from the start, in cells; 0 for all other bonds. A crack of the generator has
/// that of the notch nearest to its middle (ends are led up to the hole), one of a mesh that of the notch it lies on or
/// the pathways'; of notches that lie on each other the widest counts.
std::vector<double> crack_apertures(const Scene& scene, const Assembly& assembly, const BondEdges& bonds) {
  const RockSection& section = *scene.rock;
  const double slack = 1e-7 * (scene.lattice.length_x + scene.lattice.length_y);
  std::vector<double> apertures(bonds.vertices.size(), 0);
  std::vector<bool> found(section.notches.size(), false);
  for (const auto& crack : assembly.initial_cracks) {
    const auto bond = bonds.number.find(ordered(crack[0], crack[1]));
    if (bond == bonds.number.end()) continue;
    const auto &p = assembly.vertices[crack[0]], &q = assembly.vertices[crack[1]];
    const std::array<double, 2> middle{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
    double nearest = section.mesh ? slack : std::numeric_limits<double>::infinity();
    for (const Notch& notch : section.notches) nearest = std::min(nearest, distance(middle, notch));
    double aperture = -1;
    for (std::size_t n = 0; n < found.size(); ++n) {
      if (distance(middle, section.notches[n]) > nearest + slack) continue;
      aperture = std::max(aperture, section.notches[n].aperture);
      found[n] = true;
    }
    apertures[bond->second] = std::max(apertures[bond->second], aperture < 0 ? section.pathway_aperture : aperture);
  }
  for (std::size_t n = 0; n < found.size(); ++n)
    if (section.mesh && !found[n])
      throw InputError(fmt::format("{}: rock.notches.{}: no line of the group \"crack\" or \"notch\" of {} lies on it",
                                   scene.path, section.notches[n].entry, *section.mesh));
  return apertures;
}

/// Aperture that each bond has from the start, in cells: notches, and pathways until the porosity is reached.
std::vector<double> initial_apertures(const Scene& scene, const Lattice& lattice, const Assembly& assembly,
                                      const BondEdges& bonds, const RockRaster& raster) {
  const RockSection& section = *scene.rock;
  std::vector<double> aperture = crack_apertures(scene, assembly, bonds);
  if (section.porosity <= 0) return aperture;
  std::vector<bool> fixed(aperture.size());
  std::vector<double> wide = aperture;
  for (std::size_t b = 0; b < aperture.size(); ++b) {
    fixed[b] = aperture[b] > 0;
    if (!fixed[b]) wide[b] = section.pathway_aperture;
  }
  std::vector<std::vector<int>> strips;
  for (const auto& strip : bond_strips(scene, lattice, assembly, bonds, raster, wide)) {
    std::vector<int>& nodes = strips.emplace_back();
    for (const StripNode& entry : strip) nodes.push_back(entry.node);
  }
  const auto rock_nodes = std::count_if(raster.owner.begin(), raster.owner.end(), [](int owner) { return owner >= 0; });
  const int target = static_cast<int>(std::lround(section.porosity * static_cast<double>(rock_nodes)));
  const std::vector<bool> chosen = choose_pathways(assembly, strips, fixed, target, section.seed);
  for (std::size_t b = 0; b < aperture.size(); ++b)
    if (chosen[b]) aperture[b] = wide[b];
  return aperture;
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

/// The nodes that the widest aperture of some bond would open, and those of pathways narrower than a cell.
PathwayNodes pathway_nodes(const Scene& scene, const Lattice& lattice, const Assembly& assembly, const BondEdges& bonds,
                           const RockRaster& raster, const std::vector<double>& closed,
                           const std::vector<bool>& solid) {
  const DamageSection& damage = *scene.damage;
  std::vector<double> open(closed.size());
  for (std::size_t b = 0; b < open.size(); ++b)
    open[b] = std::max(
        {damage.pathway_factor * bonds.spacing[b] / scene.lattice.spacing, damage.minimum_aperture, closed[b]});
  const auto strips = bond_strips(scene, lattice, assembly, bonds, raster, open);
  const std::vector<double> slope = slopes_of(assembly, bonds);
  std::vector<bool> wanted = solid;
  for (std::size_t b = 0; b < strips.size(); ++b)
    if (closed[b] > 0 && closed[b] < narrowest_aperture(slope[b]))
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
  return {to_device<IndexList>("vug::pathways::node", node),
          to_device<IndexList>("vug::pathways::offset", offset),
          to_device<IndexList>("vug::pathways::bond", bond),
          to_device<ScalarField<double>>("vug::pathways::least_aperture", aperture),
          to_device<ScalarField<double>>("vug::pathways::closed", closed),
          to_device<ScalarField<double>>("vug::pathways::open", open),
          to_device<ScalarField<double>>("vug::pathways::slope", slope),
          to_device<IndexList>("vug::pathways::in_order", in_order),
          to_device<IndexList>("vug::pathways::first", first)};
}

/// The rock of a mesh file, which must lie in the lattice.
Assembly mesh_on_lattice(const LatticeSection& lattice, const std::string& file) {
  Assembly assembly = read_mesh(file);
  const double slack = 1e-9 * (lattice.length_x + lattice.length_y);
  for (const auto& [x, y] : assembly.vertices)
    if (x < -slack || x > lattice.length_x + slack || y < -slack || y > lattice.length_y + slack)
      throw InputError(
          fmt::format("{}: the point ({:g}, {:g}) m lies outside the lattice, which is [0, {:g}] x [0, {:g}] m", file,
                      x, y, lattice.length_x, lattice.length_y));
  return assembly;
}

}  // namespace

Rock build_rock(const Scene& scene, const Lattice& lattice) {
  const RockSection& section = *scene.rock;
  Rock rock;
  rock.assembly = section.mesh ? mesh_on_lattice(scene.lattice, *section.mesh)
                               : generate_rock(scene.lattice.length_x, scene.lattice.length_y, section);
  if (scene.mechanics) assign_regions(scene.mechanics->regions, scene.minerals, scene.path, rock.assembly);
  const BondEdges bonds = bond_edges(rock.assembly);
  rock.bonds = static_cast<int>(bonds.vertices.size());
  RockRaster raster = rasterise(rock.assembly, lattice, scene.lattice.spacing);
  const std::vector<int> openings = opening_of_nodes(scene);
  for (std::size_t n = 0; n < openings.size(); ++n)
    if (openings[n] >= 0) raster.owner[n] = raster.edge[n] = -1;
  const std::vector<double> closed = initial_apertures(scene, lattice, rock.assembly, bonds, raster);

  rock.solid.assign(raster.owner.size(), false);
  std::transform(raster.owner.begin(), raster.owner.end(), rock.solid.begin(), [](int owner) { return owner >= 0; });
  const auto rock_nodes = std::count(rock.solid.begin(), rock.solid.end(), true);
  for (const auto& strip : bond_strips(scene, lattice, rock.assembly, bonds, raster, closed))
    for (const StripNode& entry : strip) rock.solid[entry.node] = false;
  const auto fluid = rock_nodes - std::count(rock.solid.begin(), rock.solid.end(), true);
  rock.porosity = rock_nodes > 0 ? static_cast<double>(fluid) / static_cast<double>(rock_nodes) : 0;
  const TriangleOfNodes triangles{rock.assembly, raster.owner};
  rock.mineral = mineral_of_nodes(scene, rock.solid, {}, &triangles);
  rock.open_bonds = static_cast<int>(std::count_if(closed.begin(), closed.end(), [](double w) { return w > 0; }));
  rock.nodes_of_particle = group_nodes(raster.owner, static_cast<int>(rock.assembly.triangles.size()), lattice);
  rock.nodes_of_sector = group_nodes(sector_of_nodes(raster), 3 * rock.nodes_of_particle.count(), lattice);
  rock.sectors_of_bond = sectors_of_bonds(rock.assembly, bonds);
  rock.neighbours = neighbours_of_triangles(rock.assembly);
  if (scene.damage) rock.pathways = pathway_nodes(scene, lattice, rock.assembly, bonds, raster, closed, rock.solid);
  return rock;
}

}  // namespace vug
