#pragma once
// Where the fluid is: a compact numbering of the fluid nodes, with every wall baked into one table of sources.
//
// Flow and solutes store populations direction-major over this list: the population of direction q at fluid node i is
// entry q * capacity + i (a *slot*). A sweep pulls population q from slot source(q, i), and knows nothing else:
//   - a link to a fluid neighbour points to the neighbour's slot of the same direction;
//   - every other link (solid neighbour, edge of the lattice, opening) points to the node's own opposite slot: halfway
//     bounce-back.
//
// All other boundary conditions *dress* that outgoing population before the sweep: a pressure opening, a moving or a
// reactive wall overwrites slot (opposite(q), i), which nobody else reads, and the plain bounce-back brings it back.
#include "kernels/base/base.hpp"
#include "kernels/base/lattice.hpp"
#include "kernels/base/side.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/source_windows.hpp"

#include <array>
#include <cstdint>
#include <functional>

namespace vug {

/// Kind of a node of the dense lattice.
enum class NodeType : std::uint8_t { fluid = 0, solid = 1, opening = 2 };

/// Number of a node in an opening (opening.hpp), where a solid node has -1.
inline constexpr int in_opening = -2;

/// The compact list of fluid nodes. Births append at the end, so an index never changes.
struct FluidNodes {
  Lattice lattice;
  int count = 0;     ///< fluid nodes
  int capacity = 0;  ///< distance between directions; at least count, a multiple of 16
  /// Opposite sides that are joined: {left-right, bottom-top}.
  std::array<bool, 2> periodic{false, false};

  IndexList node;             ///< (fluid) node of the dense lattice
  IndexList index;            ///< (dense node) fluid index, -1 in solid and halo, in_opening in an opening
  Kokkos::View<int*> source;  ///< (q * capacity + fluid) slot that direction q is pulled from
  Kokkos::View<SourceWindow*>
      windows;  ///< (eight nodes, direction 1-8) the same by eights, where the host has use for it
  Kokkos::View<std::uint16_t*> solid_links;  ///< (fluid) bit q: the neighbour along +q is solid
  Kokkos::View<std::uint16_t*>
      side_links;  ///< (fluid) bit q: the neighbour along +q is outside the lattice or in an opening
  Kokkos::View<std::uint16_t*> open_links;  ///< (fluid) the side links through which fluid may flow (see mark_open)

  int own_count = -1;    ///< blocks of the list that this process computes; -1: all
  IndexList own_blocks;  ///< (own) their numbers
  int near_count = -1;   ///< these and the blocks that our nodes pull from; -1: all
  IndexList near_blocks;

  DenseNeighbour around() const { return {lattice, periodic}; }
  /// What sweeps run over.
  Share share() const { return {count, own_count, own_blocks.data()}; }
  /// Of the first `first` nodes ours and those that lie beside them.
  Share near(int first) const { return {first, near_count, near_blocks.data()}; }
};

/// Of the link masks of a fluid node those that nothing is carried along: into rock or through a closed side.
KOKKOS_FORCEINLINE_FUNCTION constexpr unsigned closed_links(unsigned solid, unsigned side, unsigned open) {
  return solid | (side & ~open);
}

/// Numbers the fluid nodes of `type` (dense, Lattice numbering) row by row and builds the tables.
FluidNodes make_fluid_nodes(const Exec& exec, const Lattice& lattice, const Kokkos::View<NodeType*>& type,
                            std::array<bool, 2> periodic = {false, false});

/// Appends every node that `type` calls fluid and that is not in the list yet, in order of node number, and brings the
/// tables up to date. Returns how many. When the capacity is too small it grows to one and a half times the nodes there
/// are then, at most those of the lattice, and `capacity` changes: populations must then be moved with `restride`. The
/// new nodes are [old count, new count).
int append_births(const Exec& exec, const Kokkos::View<NodeType*>& type, FluidNodes& nodes);

/// Replaces the list by `node` (fluid), which a checkpoint has kept, with the capacity it had then.
void set_fluid_nodes(const Exec& exec, const IndexList& node, int capacity, FluidNodes& nodes);

/// Rebuilds source, windows, solid_links, side_links and open_links of all nodes from node and index.
void rebuild_links(const Exec& exec, FluidNodes& nodes);

/// A copy of direction-major populations with a new distance between directions.
template <class T>
ScalarField<T> restride(const Exec& exec, const ScalarField<T>& populations, int directions, int count, int from,
                        int to);

/// The solid nodes that touch fluid: the stage of every process at a wall (force, reaction, dissolution). Work is done
/// per surface node over its links in a fixed order, so sums need no atomics. Row by row in node order.
struct Surface {
  int count = 0;
  IndexList node;  ///< (surface) dense node; extent may exceed count
};

/// Finds the solid nodes with at least one fluid neighbour among the eight. Reuses the allocation when it fits.
void find_surface(const Exec& exec, const FluidNodes& nodes, const Kokkos::View<NodeType*>& type, Surface& surface);

/// The fluid nodes beside a stretch of one side of the lattice or an opening, for the boundary conditions set there.
struct BoundaryLinks {
  int count = 0;
  IndexList fluid;                        ///< (link) fluid index
  Kokkos::View<std::uint8_t*> direction;  ///< (link) outward direction q whose slot is dressed
  int own_count = -1;                     ///< links that this process dresses; -1: all
  IndexList own;                          ///< (own) their numbers, ascending

  /// The link of node i in direction q, -1 where it is not in the list. Nodes that lie close to that of link `from` are
  /// close to it in the list.
  KOKKOS_FUNCTION int find(int from, int i, int q) const {
    for (int away = 0; away < count; ++away)
      for (const int link : {from - away, from + away})
        if (link >= 0 && link < count && fluid(link) == i && direction(link) == q) return link;
    return -1;
  }
};

/// Links that leave the lattice through `side` from nodes whose coordinate along it lies in [first, last], in order
/// of that coordinate. A diagonal link out of a corner leaves through two sides and belongs to the one that comes
/// first in `order`. `directions` is 9 or 5.
BoundaryLinks find_boundary_links(const Exec& exec, const FluidNodes& nodes, Side side, int first, int last,
                                  int directions, const SideOrder& order = all_sides);

/// (link) Area of the surface that each link stands for, cells: 6 w_q |n.c_q|, which adds up to the true area of a
/// plane in any direction (3 sum of w_q (n.c_q)^2 = 1), times a factor near 1 with which D2Q9 also has the sum of |n.c|
/// over the straight links where corners keep or lack diagonal ones. facing(link, q) is |n.c_q|, 1 on a side. Computed
/// on the host: not inside a step.
ScalarField<double> link_areas(
    const BoundaryLinks& links, int directions,
    const std::function<double(int, int)>& facing = [](int, int) { return 1.0; });

/// Sets the bits of `links` in nodes.open_links. Births clear those of the nodes around them: mark all anew.
void mark_open(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links);

}  // namespace vug
