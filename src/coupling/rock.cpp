#include "coupling/rock.hpp"

#include "coupling/initial_pathways.hpp"
#include "dem/edges.hpp"
#include "io/mesh_reader.hpp"
#include "io/rock_generator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace vug {

namespace {

using VertexPair = std::array<int, 2>;

VertexPair ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

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

/// Bond of each node's sub-triangle, -1 where there is none.
std::vector<int> bond_of_nodes(const Assembly& assembly, const RockRaster& raster, const BondEdges& bonds) {
  std::vector<int> bond(raster.owner.size(), -1);
  for (std::size_t n = 0; n < bond.size(); ++n) {
    if (raster.owner[n] < 0) continue;
    const auto& triangle = assembly.triangles[raster.owner[n]];
    const auto found = bonds.number.find(ordered(triangle[raster.edge[n]], triangle[(raster.edge[n] + 1) % 3]));
    if (found != bonds.number.end()) bond[n] = found->second;
  }
  return bond;
}

/// Aperture that `[rock]` gives each bond from the start, in cells.
std::vector<double> initial_apertures(const Scene& scene, const Assembly& assembly, const BondEdges& bonds,
                                      const RockRaster& raster, const std::vector<int>& bond_of_node) {
  const RockSection& section = *scene.rock;
  std::vector<double> aperture(bonds.vertices.size(), 0);
  double notch_aperture = 0;
  for (const Notch& notch : section.notches) notch_aperture = std::max(notch_aperture, notch.aperture);
  if (notch_aperture == 0) notch_aperture = section.pathway_aperture;
  for (const auto& crack : assembly.initial_cracks) {
    const auto found = bonds.number.find(ordered(crack[0], crack[1]));
    if (found != bonds.number.end()) aperture[found->second] = notch_aperture;
  }
  if (section.porosity <= 0) return aperture;

  std::vector<bool> fixed(aperture.size());
  for (std::size_t b = 0; b < aperture.size(); ++b) fixed[b] = aperture[b] > 0;
  std::vector<int> opens(aperture.size(), 0);
  int rock_nodes = 0;
  for (std::size_t n = 0; n < bond_of_node.size(); ++n) {
    if (raster.owner[n] < 0) continue;
    ++rock_nodes;
    const int b = bond_of_node[n];
    if (b < 0) continue;
    const double width = fixed[b] ? aperture[b] : section.pathway_aperture;
    if (raster.edge_distance[n] <= width / 2) ++opens[b];
  }
  const int target = static_cast<int>(std::lround(section.porosity * rock_nodes));
  const auto chosen = choose_pathways(bonds.vertices, opens, fixed, static_cast<int>(assembly.vertices.size()), target,
                                      section.seed);
  for (std::size_t b = 0; b < aperture.size(); ++b)
    if (chosen[b] && !fixed[b]) aperture[b] = section.pathway_aperture;
  return aperture;
}

template <class ViewType, class Value>
ViewType to_device(const char* label, const std::vector<Value>& values) {
  ViewType view(label, values.size());
  Kokkos::deep_copy(view, Kokkos::View<const Value*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>(values.data(), values.size()));
  return view;
}

/// The nodes that the widest aperture of their bond would open and that are solid at the start.
PathwayNodes pathway_nodes(const Scene& scene, const Lattice& lattice, const RockRaster& raster, const BondEdges& bonds,
                           const std::vector<int>& bond_of_node, const std::vector<double>& closed,
                           const std::vector<bool>& solid) {
  const DamageSection& damage = *scene.damage;
  std::vector<double> open(closed.size());
  for (std::size_t b = 0; b < open.size(); ++b)
    open[b] = std::max({damage.pathway_factor * bonds.spacing[b] / scene.lattice.spacing, damage.minimum_aperture, closed[b]});
  std::vector<int> node, bond;
  std::vector<double> distance;
  for (std::size_t n = 0; n < solid.size(); ++n) {
    const int b = bond_of_node[n];
    if (b < 0 || !solid[n] || raster.edge_distance[n] > open[b] / 2) continue;
    node.push_back(lattice.node(static_cast<int>(n) % lattice.nx, static_cast<int>(n) / lattice.nx));
    bond.push_back(b);
    distance.push_back(raster.edge_distance[n]);
  }
  return {to_device<IndexList>("vug::pathways::node", node), to_device<IndexList>("vug::pathways::bond", bond),
          to_device<ScalarField<double>>("vug::pathways::distance", distance),
          to_device<ScalarField<double>>("vug::pathways::closed", closed),
          to_device<ScalarField<double>>("vug::pathways::open", open)};
}

}  // namespace

Rock build_rock(const Scene& scene, const Lattice& lattice) {
  const RockSection& section = *scene.rock;
  Rock rock;
  rock.assembly = section.mesh ? read_mesh(*section.mesh)
                               : generate_rock(scene.lattice.length_x, scene.lattice.length_y, section);
  const BondEdges bonds = bond_edges(rock.assembly);
  rock.bonds = static_cast<int>(bonds.vertices.size());
  const RockRaster raster = rasterise(rock.assembly, lattice, scene.lattice.spacing);
  const std::vector<int> bond_of_node = bond_of_nodes(rock.assembly, raster, bonds);
  const std::vector<double> closed = initial_apertures(scene, rock.assembly, bonds, raster, bond_of_node);

  rock.solid.assign(raster.owner.size(), false);
  int rock_nodes = 0, fluid = 0;
  for (std::size_t n = 0; n < raster.owner.size(); ++n) {
    if (raster.owner[n] < 0) continue;
    const int b = bond_of_node[n];
    rock.solid[n] = b < 0 || raster.edge_distance[n] > closed[b] / 2;
    ++rock_nodes;
    if (!rock.solid[n]) ++fluid;
  }
  rock.porosity = rock_nodes > 0 ? static_cast<double>(fluid) / rock_nodes : 0;
  rock.open_bonds = static_cast<int>(std::count_if(closed.begin(), closed.end(), [](double w) { return w > 0; }));
  rock.nodes_of_particle = group_nodes(raster.owner, static_cast<int>(rock.assembly.triangles.size()), lattice);
  rock.nodes_of_bond = group_nodes(bond_of_node, rock.bonds, lattice);
  if (scene.damage) rock.pathways = pathway_nodes(scene, lattice, raster, bonds, bond_of_node, closed, rock.solid);
  return rock;
}

}  // namespace vug
