#pragma once
// Links out of corners of the lattice, which cross two sides and are in the list of one of them.
#include "coupling/stretch_links.hpp"

#include <array>
#include <vector>

namespace vug {

/// Whether a link out of a node goes across a stretch of a side as well as across its own: out of a corner.
bool crosses(const Stretch& side, const Lattice& lattice, int node, int direction);

/// Force at a link out of a corner that belongs to the other side there: of the two components of c (out + in), along
/// x and y, each pushes on the side across it.
struct CornerForce {
  const Stretch *from, *to;
  int axis;
  double force;                 ///< lattice units
  std::array<double, 2> place;  ///< of the node, cells

  /// Its moment about the centre of a stretch.
  double torque_about(const Stretch& stretch) const {
    return axis == 0 ? -(place[1] - stretch.centre[1]) * force : (place[0] - stretch.centre[0]) * force;
  }
};

/// Those of the boundary `own`, one of `boundaries`. `node` (fluid) dense indices; `out` and `in` (link of `own`) what
/// leaves and what its condition returns. A joined side has none.
template <class T>
std::vector<CornerForce> corner_forces(const Lattice& lattice, const std::vector<StretchLinks>& boundaries,
                                       const StretchLinks& own, const OnHost<IndexList>& node,
                                       const OnHost<ScalarField<T>>& out, const OnHost<ScalarField<T>>& in);

}  // namespace vug
