#pragma once
// The true surface that a wall link stands for.
#include "base/base.hpp"
#include "base/velocity_set.hpp"
#include "kernels/launch/prefetch.hpp"
#include "kernels/reaction/reaction.hpp"

namespace vug {

/// Links weighted by |n.c| with the surface's normal n: true area. Without normals every link counts in full: the area
/// of the stair-step, too large by the factor |cos| + |sin| of the wall's angle.
struct LinkArea {
  VectorField<double> normal;  ///< (surface, axis)
  KOKKOS_FORCEINLINE_FUNCTION void announce(int s) const {
    if (normal.extent(0) == 0) return;
    prefetch(&normal(s, 0));
    prefetch(&normal(s, 1));
  }
  KOKKOS_FORCEINLINE_FUNCTION double share(int s, int q) const {
    if (normal.extent(0) == 0) return 1;
    return link_area_share(normal(s, 0), normal(s, 1), D2Q9::c(q, 0), D2Q9::c(q, 1));
  }
};

}  // namespace vug
