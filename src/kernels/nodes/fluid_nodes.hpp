#pragma once
// A compact numbering of the fluid nodes, with all walls contained in one table of sources.
//
// Flow and solutes store populations direction-major over this list: the population of direction q at fluid node i is
// entry q * capacity + i (a *slot*). A sweep pulls population q from slot source(q, i) and needs no other geometry:
//   - a link to a fluid neighbour points to the neighbour's slot of the same direction;
//   - every other link (solid neighbour, edge of the lattice, opening) points to the node's own opposite slot: halfway
//     bounce-back.
//
// All other boundary conditions *dress* that outgoing population before the sweep: a pressure opening, a moving or a
// reactive wall overwrites slot (opposite(q), i), which no other node reads, and plain bounce-back brings it back.
#include "base/base.hpp"
#include "base/lattice.hpp"
#include "base/side.hpp"
#include "base/velocity_set.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/source_windows.hpp"

#include <array>
#include <cstdint>
#include <functional>

namespace vug {

/// Kind of a node of the dense lattice.
enum class NodeType : std::uint8_t { fluid = 0, solid = 1, opening = 2 };

/// Fluid index of a node in an opening (opening.hpp); a solid node has -1.
inline constexpr int in_opening = -2;

/// The compact list of fluid nodes. Births (nodes that turn fluid) are appended at the end, so an index never changes.
struct FluidNodes {
  Lattice lattice;
  int count = 0;     ///< fluid nodes
  int capacity = 0;  ///< distance between directions; at least count, a multiple of 16
  /// Opposite sides that are joined: {left-right, bottom-top}.
  std::array<bool, 2> periodic{false, false};

  IndexList node;                       ///< (fluid) node of the dense lattice
  IndexList index;                      ///< (dense node) fluid index, -1 in solid and halo, in_opening in an opening
  Kokkos::View<int*> source;            ///< (q * capacity + fluid) slot that direction q is pulled from
  Kokkos::View<SourceWindow*> windows;  ///< (eight nodes, direction 1-8) the same by eights; with has_source_windows
  Kokkos::View<std::uint16_t*> solid_links;  ///< (fluid) bit q: the neighbour along +q is solid
  Kokkos::View<std::uint16_t*>
      side_links;  ///< (fluid) bit q: the neighbour along +q is outside the lattice or in an opening
  Kokkos::View<std::uint16_t*> open_links;  ///< (fluid) the side links through which fluid may flow (see mark_open)

  int own_count = -1;    ///< number of blocks of the list that this process computes; -1: all
  IndexList own_blocks;  ///< (own) their numbers
  int near_count = -1;   ///< number of these and of the blocks from which their nodes pull; -1: all
  IndexList near_blocks;

  DenseNeighbour around() const { return {lattice, periodic}; }
  /// The nodes that a sweep computes.
  Share share() const { return {count, own_count, own_blocks.data()}; }
  /// Of the first `first` nodes, those of this process and those beside them.
  Share near(int first) const { return {first, near_count, near_blocks.data()}; }
};

/// From the link masks of a fluid node, the mask of links along which nothing is advected: into rock or through a
/// closed side.
KOKKOS_FORCEINLINE_FUNCTION constexpr unsigned closed_links(unsigned solid, unsigned side, unsigned open) {
  return solid | (side & ~open);
}

/// Numbers the fluid nodes of `type` (dense, Lattice numbering) row by row and builds the tables.
FluidNodes make_fluid_nodes(const Exec& exec, const Lattice& lattice, const Kokkos::View<NodeType*>& type,
                            std::array<bool, 2> periodic = {false, false});

/// Appends every node that is fluid in `type` and not in the list yet, in order of node number, and updates the tables.
/// Returns the number of new nodes. A capacity that is too small grows to one and a half times the new count, at most
/// the number of nodes of the lattice: populations must then be moved with `restride`. The new nodes are [old count,
/// new count).
int append_births(const Exec& exec, const Kokkos::View<NodeType*>& type, FluidNodes& nodes);

/// Replaces the list by `node` (fluid) from a checkpoint, with the capacity that it had then.
void set_fluid_nodes(const Exec& exec, const IndexList& node, int capacity, FluidNodes& nodes);

/// Rebuilds source, windows, solid_links, side_links and open_links of all nodes from node and index.
void rebuild_links(const Exec& exec, FluidNodes& nodes);

/// A copy of direction-major populations with a new distance between directions.
template <class T>
ScalarField<T> restride(const Exec& exec, const ScalarField<T>& populations, int directions, int count, int from,
                        int to);

/// Moves the first `count` nodes of direction-major populations and of a field (fluid) to the capacity of `nodes`, if
/// it has changed.
template <class T, class Field>
void fit_to_capacity(const Exec& exec, const FluidNodes& nodes, int directions, int count, ScalarField<T>& populations,
                     Field& field) {
  const int old = static_cast<int>(field.extent(0));
  if (old == nodes.capacity) return;
  populations = restride(exec, populations, directions, count, old, nodes.capacity);
  Kokkos::resize(exec, field, nodes.capacity);
}

/// The solid nodes that touch fluid, where all processes at walls act (force, reaction, dissolution). Work is done per
/// surface node over its links in a fixed order, so sums need no atomics. Sorted by node number.
struct Surface {
  int count = 0;
  IndexList node;  ///< (surface) dense node; extent may exceed count
};

/// Finds the solid nodes with at least one fluid node among their eight neighbours. Reuses the allocation when it fits.
void find_surface(const Exec& exec, const FluidNodes& nodes, const Kokkos::View<NodeType*>& type, Surface& surface);

/// The fluid nodes beside a stretch of one side of the lattice or an opening, for the boundary conditions set there.
struct BoundaryLinks {
  int count = 0;
  IndexList fluid;                        ///< (link) fluid index
  Kokkos::View<std::uint8_t*> direction;  ///< (link) outward direction q whose slot is dressed
  int own_count = -1;                     ///< number of links that this process dresses; -1: all
  IndexList own;                          ///< (own) their numbers, ascending

  /// The link of node i in direction q, -1 where it is not in the list. Searches outwards from link `from`: links of
  /// nearby nodes are close to each other in the list.
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
/// plane in any direction (3 sum of w_q (n.c_q)^2 = 1), times a factor near 1. With this factor the areas of D2Q9 add
/// up to the sum of |n.c| over the straight links, also where corners have more or fewer diagonal links. facing(link,
/// q) is |n.c_q|, 1 on a side. Computed on the host: not inside a step.
ScalarField<double> link_areas(
    const BoundaryLinks& links, int directions,
    const std::function<double(int, int)>& facing = [](int, int) { return 1.0; });

/// Sets the bits of `links` in nodes.open_links. Births clear the bits of the nodes around them: all links must then be
/// marked again.
void mark_open(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links);

/// The fluid node from which fluid node i pulls direction q, by the table of sources (a View or a pointer); -1 if there
/// is none.
template <class Source>
KOKKOS_FORCEINLINE_FUNCTION int upstream_node(const Source& source, int capacity, int q, int i) {
  const int slot = q * capacity, node = source[slot + i] - slot;
  return node >= 0 && node < capacity ? node : -1;
}

/// The fluid neighbour along direction q; -1 if there is none.
template <class Source>
KOKKOS_FORCEINLINE_FUNCTION int fluid_neighbour(const Source& source, int capacity, int q, int i) {
  return upstream_node(source, capacity, D2Q9::opposite(q), i);
}

/// (link) The mirror image of each of the `links` of D2Q9 through one stretch of a side or into one opening; -1 if
/// there is none. A mirror half way along the straight links reflects what leaves along a diagonal to the node beside:
///   - a straight link is its own image; so is a diagonal one at a corner of the surface, where there is no mirror;
///   - two diagonal links that cross beside a flat piece of the surface are images of each other;
///   - a diagonal link whose image would start in rock, behind a wall or beyond the end of the stretch has none.
/// On a staircase, a surface with more steps than a rectangle has corners, every link is its own image: mirrors at
/// right angles to each other would reverse the whole velocity and let nothing through.
IndexList find_mirror_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links);

}  // namespace vug
