#pragma once
// Pathways narrower than a cell. Their nodes are fluid; a drag on the flow and a reduced exchange of solutes make them
// conduct no more than the crack does (docs/model.md, "Cracks narrower than a cell").
#include "coupling/geometry.hpp"
#include "coupling/pathways.hpp"
#include "io/field_list.hpp"

namespace vug {

/// Resistance and openness of the nodes along bonds. A crack widens where acid dissolves its walls.
class Slits {
 public:
  explicit Slits(const PathwayNodes& nodes);
  /// Determines them from what the bonds conduct and the rock that has dissolved, and lists the slits in the geometry.
  /// Waits for the device.
  void update(const Exec& exec, const BondPathways& bonds, Geometry& geometry);
  /// Lists the slits of a checkpoint.
  void restored(const Exec& exec, Geometry& geometry) const { list(exec, geometry); }
  /// `below_a_cell`: pathways may be narrower than a cell; otherwise all are open.
  void state(StateList& list, bool below_a_cell) {
    list.add("growth/resistance", resistance_);
    if (below_a_cell) list.add("growth/openness", openness_);
  }

 private:
  void list(const Exec& exec, Geometry& geometry) const;

  PathwayNodes nodes_;
  ScalarField<double> resistance_;  ///< (place) 1/k, 1/cells^2
  ScalarField<double> openness_;    ///< (place) part of D that passes (solute/slit_diffusion.hpp)
  IndexList listed_;                ///< (place + 1) number of slits before it
};

}  // namespace vug
