#pragma once
// Fluid nodes whose pore is narrower than a cell: data for the drag of their walls (flow/slit_drag.hpp) and the
// diffusion along them (solute/slit_diffusion.hpp).
#include "base/base.hpp"

namespace vug {

/// The nodes of cracks narrower than a cell, in groups: group g has [first(g), first(g + 1)).
struct SlitNodes {
  int count = 0;
  IndexList fluid;                 ///< (slit) fluid index
  ScalarField<double> resistance;  ///< (slit) 1/k, 1/cells^2
  IndexList first;                 ///< (group + 1)
  ScalarField<double> openness;    ///< (fluid) part of D that a node conducts; 1 where it is no slit or beyond the end

  /// Openness of a fluid node.
  KOKKOS_FORCEINLINE_FUNCTION double openness_of(int i) const {
    return static_cast<std::size_t>(i) < openness.extent(0) ? openness(i) : 1.0;
  }
};

}  // namespace vug
