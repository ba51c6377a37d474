#pragma once
// The true orientation of a stair-step surface, from the solid volume around it.
#include "kernels/nodes/fluid_nodes.hpp"

#include <optional>

namespace vug {

/// Normal n = -grad V/|grad V| at every surface node, pointing into the fluid, from the share V of each node's own
/// solid that is left (solid_share of `volume` and `dissolved`, dense) over 5 x 5 nodes with Gaussian weights; zero
/// where it is undefined (a lone pixel). Its length is 1 on a flat wall and follows the curvature elsewhere: the
/// outline of pixels that are partly dissolved is longer than the surface inside them, or shorter in a hollow. V beyond
/// a side is that of the nearest node inside. normal: (surface, axis); its allocation is reused when it fits. To be
/// renewed when the surface or V has changed noticeably. Reads 25 x 16 bytes per surface node. With `only`, computed
/// for those surface nodes only.
void find_normals(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ScalarField<double>& volume,
                  const ScalarField<double>& dissolved, VectorField<double>& normal,
                  const std::optional<Share>& only = {});

/// Which solid nodes react: those of minerals that do, all where there are no minerals.
struct ReactingNodes {
  Kokkos::View<const std::uint8_t*> mineral{};  ///< (dense node) number of its mineral; empty: none has one
  Kokkos::View<const std::uint8_t*> reacts{};   ///< (mineral) 1 or 0
  KOKKOS_FORCEINLINE_FUNCTION bool operator()(int node) const {
    return mineral.extent(0) == 0 || reacts(mineral(node)) != 0;
  }
};

/// Area of the reactive surface in nodes (per node of depth): sum over the links between reacting solid and fluid of
/// 6 w |n.c|, which is the true length of a straight wall of any orientation. Without normals (extent 0) the area of
/// the stair-step. Waits for the device; for the history, not inside a step.
template <class Set>
double surface_area(const Exec& exec, const FluidNodes& nodes, const Surface& surface,
                    const VectorField<double>& normal, const ReactingNodes& reacts = {});

}  // namespace vug
