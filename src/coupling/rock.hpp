#pragma once
// The rock of a scene on the lattice: triangles, pixels, bonds and the pathways along them.
#include "coupling/pathways.hpp"
#include "coupling/rock_map.hpp"
#include "dem/assembly.hpp"
#include "io/scene.hpp"

#include <vector>

namespace vug {

/// The rock at set-up. Bonds are the edges that two triangles share, in the order of find_edges.
struct Rock {
  Assembly assembly;
  int bonds = 0;
  std::vector<bool> solid;            ///< (node, row by row without halo) at the start
  std::vector<std::uint8_t> mineral;  ///< (node) as returned by mineral_of_nodes
  NodeGroups nodes_of_particle;       ///< all nodes whose centre is in the triangle
  NodeGroups nodes_of_sector;         ///< those of its sub-triangles; sector 3 * triangle + k is at the edge (k, k + 1)
  SectorPairs sectors_of_bond;        ///< the sectors at the shared edge: the bond's region (Eq. 25)
  TriangleNeighbours neighbours;      ///< across the shared edges
  PathwayNodes pathways;              ///< nodes that damage may open; empty without [damage]
  double porosity = 0;                ///< share of the triangles' nodes that are fluid at the start
};

/// Generates or reads the triangles of `scene.rock`, draws them on the lattice, and opens initial pathways and notches.
Rock build_rock(const Scene& scene, const Lattice& lattice);

}  // namespace vug
