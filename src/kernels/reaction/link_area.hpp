#pragma once
// The true surface that a wall link stands for: policies of the kernels at a reactive wall.
#include "kernels/base/base.hpp"
#include "kernels/base/velocity_set.hpp"
#include "kernels/launch/prefetch.hpp"
#include "kernels/reaction/reaction.hpp"

namespace vug {

/// Every link counts in full: the area of the stair-step, too large by the factor |cos| + |sin| of the wall's angle.
struct StaircaseArea {
  KOKKOS_FORCEINLINE_FUNCTION void announce(int) const {}
  KOKKOS_FORCEINLINE_FUNCTION double share(int, int) const { return 1; }
};

/// Links weighted by |n.c| with the surface's normal n: true area.
struct NormalArea {
  VectorField<double> normal;  ///< (surface, axis)
  KOKKOS_FORCEINLINE_FUNCTION void announce(int s) const {
    prefetch(&normal(s, 0));
    prefetch(&normal(s, 1));
  }
  KOKKOS_FORCEINLINE_FUNCTION double share(int s, int q) const {
    return link_area_share(normal(s, 0), normal(s, 1), D2Q9::c(q, 0), D2Q9::c(q, 1));
  }
};

/// Calls with NormalArea where there are normals, with StaircaseArea where there are none.
template <class Call>
void with_link_area(const VectorField<double>& normal, const Call& call) {
  if (normal.extent(0) > 0)
    call(NormalArea{normal});
  else
    call(StaircaseArea{});
}

}  // namespace vug
