#pragma once
// Which bonds carry a pathway, how wide it is and which nodes it opens (docs/model.md, "Pathways").
#include "coupling/pathways.hpp"
#include "coupling/rock_map.hpp"
#include "coupling/strip.hpp"
#include "dem/assembly.hpp"
#include "io/scene.hpp"

#include <array>
#include <map>
#include <vector>

namespace vug {

using VertexPair = std::array<int, 2>;

inline VertexPair ordered(int a, int b) {
  return a < b ? VertexPair{a, b} : VertexPair{b, a};
}

/// The shared edges, with what a pathway along them needs, in the order of find_edges.
struct BondEdges {
  std::vector<VertexPair> vertices;  ///< (bond) low, high
  std::vector<double> length;        ///< (bond) m
  std::vector<double> spacing;       ///< (bond) distance of the two centroids across the edge, m
  std::map<VertexPair, int> number;
};
BondEdges bond_edges(const Assembly& assembly);

/// Width of each bond at the start, in cells: notches, and pathways until the porosity is reached. With widths in
/// metres the same bonds have pathways on any lattice. Throws InputError for a notch that is not on the mesh, and for
/// widths too small for the lattice.
std::vector<double> initial_widths(const Scene& scene, const Lattice& lattice, const Assembly& assembly,
                                   const BondEdges& bonds, const RockRaster& raster);

/// The nodes of the rock that a pathway of `width` (bond, cells) along each bond opens.
std::vector<std::vector<StripNode>> bond_strips(const Scene& scene, const Lattice& lattice, const Assembly& assembly,
                                                const BondEdges& bonds, const RockRaster& raster,
                                                const std::vector<double>& width);

/// The nodes that the widest pathway of any bond would open, and those of pathways narrower than a cell. `closed`: the
/// initial widths; `solid`: (node) the solid that these leave.
PathwayNodes pathway_nodes(const Scene& scene, const Lattice& lattice, const Assembly& assembly, const BondEdges& bonds,
                           const RockRaster& raster, const std::vector<double>& closed, const std::vector<bool>& solid);

}  // namespace vug
