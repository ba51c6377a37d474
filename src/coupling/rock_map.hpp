#pragma once
// The triangle and the bond to which a node belongs. Displacements are micrometres where nodes are tens of micrometres
// apart, so the rock is drawn on the lattice once, in its initial position (paper section 3.3).
#include "base/lattice.hpp"
#include "dem/assembly.hpp"

#include <vector>

namespace vug {

/// Nodes of the lattice in groups, stored as runs of consecutive nodes: the runs of group g are [offset(g),
/// offset(g + 1)). A triangle of the paper's rock has 250 nodes in 22 runs, which takes 0.7 bytes per node instead of
/// the 4 of a number.
struct NodeGroups {
  IndexList offset;  ///< (group + 1)
  IndexList first;   ///< (run) first dense node
  IndexList length;  ///< (run) number of nodes
  IndexList nodes;   ///< (group) number of nodes
  int count() const { return static_cast<int>(offset.extent(0)) - 1; }
  /// Calls visit(node) for the nodes of group g in order.
  template <class Visit>
  KOKKOS_FORCEINLINE_FUNCTION void for_each(int g, const Visit& visit) const {
    for (int r = offset(g); r < offset(g + 1); ++r)
      for (int n = first(r); n < first(r) + length(r); ++n) visit(n);
  }
};

/// (bond, end) sector.
using SectorPairs = Kokkos::View<int* [2], Kokkos::LayoutLeft>;

/// The rock on the lattice, on the host, for each node row by row without halo.
struct RockRaster {
  std::vector<int> owner;  ///< triangle, -1 where there is none
  std::vector<int> edge;   ///< 0..2: the edge (vertices edge, edge + 1) whose sub-triangle holds the node
};

/// Draws the triangles. A node belongs to the triangle that holds its centre (on an edge as in cells.hpp), and in it to
/// the sub-triangle (centroid, p, q) of the edge whose opposite barycentric coordinate is smallest.
RockRaster rasterise(const Assembly& assembly, const Lattice& lattice, double spacing);

/// Groups the dense nodes by a key per node (row by row without halo; negative keys are left out).
NodeGroups group_nodes(const std::vector<int>& key, int groups, const Lattice& lattice);

}  // namespace vug
