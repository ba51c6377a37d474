#pragma once
// How damage conducts: each bond carries a strip of nodes that turn fluid as its mechanical damage grows (paper
// sections 2.4, 3.1; the closure with c_d is in docs/model.md, "Pathways").
#include "coupling/slit.hpp"
#include "coupling/solid_spread.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

class Mechanics;

/// Aperture of the strip of a bond in cells: w(d_m) = w_0 + d_m (w_1 - w_0).
KOKKOS_FORCEINLINE_FUNCTION double pathway_aperture(double d_m, double closed, double open) {
  return closed + d_m * (open - closed);
}

/// The narrowest crack that has a pathway, in cells; it conducts 1e-7 cells^3.
inline constexpr double narrowest_slit = 0.01;

/// Aperture of the strip of nodes for a slot of `width` cells, 0 where there is none. Drag on these nodes makes them
/// conduct no more than the slot.
KOKKOS_FORCEINLINE_FUNCTION double strip_of_slot(double width) {
  return width < narrowest_slit ? 0.0 : Kokkos::fmax(1.0, slot_aperture(cubic_law(width)));
}

/// The nodes near bonds that are solid, or fluid in a pathway narrower than a cell, each with the bonds to whose strips
/// it may belong.
struct PathwayNodes {
  IndexList node;              ///< (candidate) dense node
  IndexList offset;            ///< (candidate + 1) the entries of candidate c are [offset(c), offset(c + 1))
  IndexList bond;              ///< (entry)
  ScalarField<double> least;   ///< (entry) smallest aperture at which the bond's strip holds the node, cells
  ScalarField<double> closed;  ///< (bond) aperture w_0 at d_m = 0, cells
  ScalarField<double> open;    ///< (bond) aperture w_1 at d_m = 1, cells
  bool cubic = false;          ///< apertures are widths of slots of any size; otherwise of rows of nodes
  ScalarField<double> slope;   ///< (bond) slope of the edge to the axis that it follows more closely, 0 to 1
  ScalarField<double> filled;  ///< (candidate) part of its cell that slits fill at the start
  IndexList in_order;          ///< (place) candidates, sorted by the triangle that holds them
  IndexList first;             ///< (triangle + 1) the places of triangle t are [first(t), first(t + 1))
};

/// What each bond conducts now.
struct BondPathways {
  ScalarField<double> strip;         ///< (bond) aperture of its strip of whole nodes, cells
  ScalarField<double> widest;        ///< (bond) widest strip so far: the nodes that it has opened stay fluid
  ScalarField<double> conductivity;  ///< (bond) cells^3; if below that of the narrowest strip, its nodes are slits
};

/// Turns the nodes fluid that the apertures of bonds open, and never back. The solid volume of each is spread over the
/// nodes around it.
class PathwayOpener {
 public:
  PathwayOpener(const Lattice& lattice, PathwayNodes nodes, SolidSpread spread);
  /// From now on pathways are as wide as the openings of cracks in `rock`; otherwise they follow d_m. residual and
  /// spacing: m.
  void follow_cracks(const Mechanics& rock, double residual, double spacing);
  /// Number of bonds whose conduction has changed since the last look, and of all that conduct less than their open
  /// nodes would.
  struct Look {
    int changed = 0, narrow = 0;
    KOKKOS_FUNCTION Look& operator+=(const Look& other) {
      changed += other.changed;
      narrow += other.narrow;
      return *this;
    }
  };
  Look look(const Exec& exec, const ScalarField<double>& d_m);
  /// Opens nodes and returns their number. `volume` and `dissolved` may be empty (a scene without dissolution).
  int open(const Exec& exec, const Kokkos::View<NodeType*>& type, const ScalarField<double>& volume,
           const ScalarField<double>& dissolved);
  /// To be called once, at the start. Returns to the nodes around what the whole nodes of pathways narrower than a cell
  /// have taken of the rock beyond their widths. Returns the volume that found no room, pixels.
  double return_solid(const Exec& exec, const Kokkos::View<NodeType*>& type, const ScalarField<double>& volume,
                      const ScalarField<double>& dissolved);
  const PathwayNodes& nodes() const { return nodes_; }
  const BondPathways& bonds() const { return bonds_; }
  bool follows_cracks() const { return rock_ != nullptr; }
  /// (bond) opening of the crack, cells; empty where pathways follow d_m
  const ScalarField<double>& gap() const { return gap_; }
  int parts() const { return spread_.parts(); }  ///< number of minerals, or 1
  /// (triangle) solid volume of a mineral that has found no room, pixels.
  const ScalarField<double>& waiting(int mineral = 0) const { return spread_.waiting(mineral); }

 private:
  PathwayNodes nodes_;
  SolidSpread spread_;
  Kokkos::View<std::uint8_t*> opening_;  ///< (dense node) 1 while its volume is being moved
  const Mechanics* rock_ = nullptr;
  double residual_ = 0, spacing_ = 1;
  ScalarField<double> gap_;  ///< (bond) opening of the crack, cells; empty where pathways follow d_m
  BondPathways bonds_;       ///< at the last look; -1 before the first
};

}  // namespace vug
