#pragma once
// Pathways narrower than a cell: their nodes are fluid, and drag and what holds solutes back make them conduct as
// little as the crack does (docs/model.md, "Cracks narrower than a cell").
#include "coupling/geometry.hpp"
#include "coupling/module.hpp"
#include "coupling/pathways.hpp"

namespace vug {

/// Resistance and openness of the nodes along bonds. Acid that etches the walls of a crack widens it.
class Slits {
 public:
  explicit Slits(const PathwayNodes& nodes);
  /// From what the bonds conduct and the rock that has dissolved; lists the slits in the geometry. Waits for the
  /// device.
  void update(const Exec& exec, const BondPathways& bonds, Geometry& geometry);
  /// Lists the slits of a checkpoint.
  void restored(const Exec& exec, Geometry& geometry) const { list(exec, geometry); }
  /// `below_a_cell`: whether pathways may be narrower than one; else all are open.
  void state(StateList& list, bool below_a_cell) {
    list.add("growth/resistance", resistance_);
    if (below_a_cell) list.add("growth/openness", openness_);
  }

 private:
  void list(const Exec& exec, Geometry& geometry) const;

  PathwayNodes nodes_;
  ScalarField<double> resistance_;  ///< (place) 1/k, 1/cells^2
  ScalarField<double> openness_;    ///< (place) part of D that passes (solute/slit_diffusion.hpp)
  IndexList listed_;                ///< (place + 1) how many slits come before it
};

}  // namespace vug
