#include "coupling/rock.hpp"

#include "base/require.hpp"
#include "coupling/geometry.hpp"
#include "coupling/minerals.hpp"
#include "coupling/rock_pathways.hpp"
#include "dem/edges.hpp"
#include "io/mesh_reader.hpp"
#include "io/rock_generator.hpp"
#include "io/rock_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vug {

namespace {

/// Sector of each node (see Rock), -1 where there is none.
std::vector<int> sector_of_nodes(const RockRaster& raster) {
  std::vector<int> sector(raster.owner.size(), -1);
  for (std::size_t n = 0; n < sector.size(); ++n)
    if (raster.owner[n] >= 0) sector[n] = 3 * raster.owner[n] + raster.edge[n];
  return sector;
}

SectorPairs sectors_of_bonds(const Assembly& assembly, const BondEdges& bonds) {
  const SectorPairs sectors("vug::rock_map::sectors_of_bond", bonds.vertices.size());
  const HostWriter host(sectors);
  std::vector<int> found(bonds.vertices.size(), 0);
  for (std::size_t t = 0; t < assembly.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto& triangle = assembly.triangles[t];
      const auto bond = bonds.number.find(ordered(triangle[k], triangle[(k + 1) % 3]));
      if (bond != bonds.number.end()) host(bond->second, found[bond->second]++) = 3 * static_cast<int>(t) + k;
    }
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

/// Reads the rock of a mesh file, which must lie inside the lattice.
Assembly mesh_on_lattice(const LatticeSection& lattice, const std::string& file) {
  Assembly assembly = read_mesh(file);
  const double slack = 1e-9 * (lattice.length_x + lattice.length_y);
  const auto lies_outside = [&](double unit) {  // m, in which the mesh is written
    return std::find_if(assembly.vertices.begin(), assembly.vertices.end(), [&](const auto& vertex) {
      const double x = unit * vertex[0], y = unit * vertex[1];
      return x < -slack || x > lattice.length_x + slack || y < -slack || y > lattice.length_y + slack;
    });
  };
  const auto none = assembly.vertices.end();
  if (const auto outside = lies_outside(1); outside != none) {
    const bool millimetres = lies_outside(1e-3) == none && lies_outside(1e-2) != none;
    throw InputError(
        fmt::format("{}: the point ({:g}, {:g}) m lies outside the lattice, which is [0, {:g}] x [0, {:g}] m{}", file,
                    (*outside)[0], (*outside)[1], lattice.length_x, lattice.length_y,
                    millimetres ? "; a mesh in millimetres is to be written in metres" : ""));
  }
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
  const std::vector<double> closed = initial_widths(scene, lattice, rock.assembly, bonds, raster);

  rock.solid.assign(raster.owner.size(), false);
  std::transform(raster.owner.begin(), raster.owner.end(), rock.solid.begin(), [](int owner) { return owner >= 0; });
  const auto rock_nodes = std::count(rock.solid.begin(), rock.solid.end(), true);
  for (const auto& strip : bond_strips(scene, lattice, rock.assembly, bonds, raster, closed))
    for (const StripNode& entry : strip) rock.solid[entry.node] = false;
  const auto fluid = rock_nodes - std::count(rock.solid.begin(), rock.solid.end(), true);
  rock.porosity = rock_nodes > 0 ? static_cast<double>(fluid) / static_cast<double>(rock_nodes) : 0;
  const TriangleOfNodes triangles{rock.assembly, raster.owner};
  rock.mineral = mineral_of_nodes(scene, rock.solid, {}, &triangles);
  rock.nodes_of_particle = group_nodes(raster.owner, static_cast<int>(rock.assembly.triangles.size()), lattice);
  rock.nodes_of_sector = group_nodes(sector_of_nodes(raster), 3 * rock.nodes_of_particle.count(), lattice);
  rock.sectors_of_bond = sectors_of_bonds(rock.assembly, bonds);
  rock.neighbours = neighbours_of_triangles(rock.assembly);
  if (scene.damage) rock.pathways = pathway_nodes(scene, lattice, rock.assembly, bonds, raster, closed, rock.solid);
  return rock;
}

}  // namespace vug
