#pragma once
// Fluid nodes that stand for less than a cell of pore: the drag of their walls (flow/slit_drag.hpp) and what diffuses
// along them (solute/slit_diffusion.hpp).
#include "kernels/base/base.hpp"

namespace vug {

/// The nodes of cracks narrower than a cell, in groups: group g has [first(g), first(g + 1)).
struct SlitNodes {
  int count = 0;
  IndexList fluid;                 ///< (slit) fluid index
  ScalarField<double> resistance;  ///< (slit) 1/k, 1/cells^2 (flow/slit.hpp)
  IndexList first;                 ///< (group + 1)
  ScalarField<double> openness;    ///< (fluid) part of D that a node lets pass, 1 where it is no slit or behind the end

  /// Of a fluid node.
  KOKKOS_FORCEINLINE_FUNCTION double openness_of(int i) const {
    return static_cast<std::size_t>(i) < openness.extent(0) ? openness(i) : 1.0;
  }
};

}  // namespace vug
