#pragma once
// How damage conducts: each bond carries a strip of nodes that turn fluid as its mechanical damage grows
// (paper sections 2.4, 3.1; closure with c_d in docs/model.md, "Pathways").
#include "coupling/solid_spread.hpp"
#include "kernels/fluid_nodes.hpp"

namespace vug {

/// Aperture of the strip of a bond in cells: w(d_m) = w_0 + d_m (w_1 - w_0).
KOKKOS_FORCEINLINE_FUNCTION double pathway_aperture(double d_m, double closed, double open) {
  return closed + d_m * (open - closed);
}

/// The solid nodes near bonds, each with the bonds whose strip it may belong to.
struct PathwayNodes {
  IndexList node;              ///< (candidate) dense node
  IndexList offset;            ///< (candidate + 1) its entries are [offset(c), offset(c + 1))
  IndexList bond;              ///< (entry)
  ScalarField<double> least;   ///< (entry) aperture from which the bond's strip holds the node, cells (strip_nodes)
  ScalarField<double> closed;  ///< (bond) aperture w_0 at d_m = 0, cells
  ScalarField<double> open;    ///< (bond) aperture w_1 at d_m = 1, cells
};

/// Turns fluid the nodes that the aperture of a bond opens, never back, and has the solid volume of each spread over
/// the nodes around it. `volume` and `dissolved` may be empty (a scene without dissolution). Returns how many nodes
/// opened.
class PathwayOpener {
 public:
  PathwayOpener(const Lattice& lattice, PathwayNodes nodes, SolidSpread spread);
  int open(const Exec& exec, const ScalarField<double>& d_m, const Kokkos::View<NodeType*>& type,
           const ScalarField<double>& volume, const ScalarField<double>& dissolved);
  int parts() const { return spread_.parts(); }  ///< minerals, or 1
  /// (triangle) solid volume of a mineral that has found no room, pixels.
  const ScalarField<double>& waiting(int mineral = 0) const { return spread_.waiting(mineral); }

 private:
  PathwayNodes nodes_;
  SolidSpread spread_;
  Kokkos::View<std::uint8_t*> opening_;  ///< (dense node) 1 while its volume is being handed on
  ScalarField<double> aperture_;         ///< (bond) at the last look, cells; -1 before the first
};

}  // namespace vug
