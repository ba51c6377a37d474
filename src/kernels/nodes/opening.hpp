#pragma once
// Openings inside the lattice: a well, a heated pipe, a reservoir. The nodes of an opening are neither fluid nor solid,
// and nothing is computed in them. Its surface has boundary conditions of its own, which dress the links into it in the
// same way as links through a side.
#include "kernels/nodes/fluid_nodes.hpp"

#include <array>
#include <functional>
#include <vector>

namespace vug {

/// The nodes of one opening and the orientation of its surface at the links into it.
struct Opening {
  IndexList node;  ///< (item) dense nodes of type NodeType::opening
  /// (8 item + q - 1) |n.c_q|, n the unit normal of the surface half way along link q, times a factor near 1 with which
  /// the straight links add up to the length of the outline.
  ScalarField<double> facing;
};

/// The unit normal of a surface where a line crosses it: near `at` (cells), on a face with the outward direction `out`.
using OutlineNormal =
    std::function<std::array<double, 2>(const std::array<double, 2>& at, const std::array<double, 2>& out)>;

/// Makes an opening of `nodes` (dense nodes of the lattice). `scale` is the factor in Opening::facing.
Opening make_opening(const Lattice& lattice, const std::vector<int>& nodes, const OutlineNormal& normal,
                     double scale = 1);

/// Links from fluid nodes into the opening, in order of its nodes; `directions` is 9 or 5.
BoundaryLinks find_opening_links(const Exec& exec, const FluidNodes& nodes, const Opening& opening, int directions);

/// Links into the opening from all other nodes of the lattice, for fields that are on every node.
struct DenseLinks {
  int count = 0;
  IndexList node;                         ///< (link) dense node
  IndexList beyond;                       ///< (link) dense node in the opening, joined sides folded back
  Kokkos::View<std::uint8_t*> direction;  ///< (link) from node to beyond
  ScalarField<double> area;               ///< (link) of the surface, cells (see link_areas)
};
DenseLinks find_dense_opening_links(const Exec& exec, const Lattice& lattice, std::array<bool, 2> periodic,
                                    const Kokkos::View<NodeType*>& type, const Opening& opening, int directions);

/// (link) Areas of the links of find_opening_links, as above; over a whole shape they add up to the length of its
/// outline.
ScalarField<double> link_areas(const Exec& exec, const FluidNodes& nodes, const Opening& opening, int directions);

}  // namespace vug
