#pragma once
// Links out of corners of the lattice, which cross two sides and are in the list of one of them.
#include "coupling/stretch_links.hpp"

#include <array>
#include <vector>

namespace vug {

/// Whether a link out of a node goes across a stretch of a side as well as across its own: out of a corner.
bool crosses(const Stretch& side, const Lattice& lattice, int node, int direction);

/// Links of a boundary with what passes through them in a step, on the host.
template <class T>
struct PassedLinks {
  const StretchLinks* boundary;
  OnHost<IndexList> fluid;                               ///< (link) dense index
  OnHost<decltype(BoundaryLinks::direction)> direction;  ///< (link) of D2Q9
  OnHost<ScalarField<T>> out, in;                        ///< (link) what leaves, and what the condition returns

  PassedLinks(const StretchLinks& boundary_, const ScalarField<T>& out_, const ScalarField<T>& in_)
      : boundary(&boundary_),
        fluid(on_host(boundary_.links.fluid)),
        direction(on_host(boundary_.links.direction)),
        out(on_host(out_)),
        in(on_host(in_)) {}

  /// The momentum that a link hands over is this times its direction.
  double momentum(int link) const { return static_cast<double>(out(link)) + static_cast<double>(in(link)); }
};

/// What of the force at a link out of a corner acts on the side across it that does not have the link.
struct CornerForce {
  const Stretch *from, *to;
  std::array<double, 2> force;  ///< lattice units
  std::array<double, 2> place;  ///< of the node, cells

  /// Its moment about the centre of a stretch.
  double torque_about(const Stretch& stretch) const {
    return (place[0] - stretch.centre[0]) * force[1] - (place[1] - stretch.centre[1]) * force[0];
  }
};

/// Those of all boundaries. A link in direction c hands over 2 w (p - rho nu 3 c.S.c) c, p at its middle. Of its
/// component along an axis, pressure acts on the side across that axis: as much of it as a diagonal link has of the
/// straight one of that side, a quarter, half a cell beyond the corner's node. What is left is shear along the other
/// side. `node` (fluid): dense indices. A joined side has none.
template <class T>
std::vector<CornerForce> corner_forces(const Lattice& lattice, const std::vector<PassedLinks<T>>& boundaries,
                                       const OnHost<IndexList>& node);

}  // namespace vug
