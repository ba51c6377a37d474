#pragma once
// Which sides are joined to the opposite ones.
#include "io/scene.hpp"

namespace vug {

/// Whether this side is joined to the opposite one, for all of fluid, heat and solutes that the scene has.
inline bool is_periodic(const Scene& scene, const BoundarySection& side) {
  return (scene.flow && side.flow.kind == FlowBoundaryKind::periodic) ||
         (scene.heat && side.heat.kind == HeatCondition::periodic) ||
         (scene.solute && side.solute.kind == SoluteBoundaryKind::periodic);
}

}  // namespace vug
