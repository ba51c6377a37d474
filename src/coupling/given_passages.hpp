#pragma once
// What given velocities and rates mean in the passages behind them.
#include "coupling/flow_paths.hpp"
#include "coupling/mouths.hpp"
#include "coupling/pore_width.hpp"

#include <vector>

namespace vug {

/// Enlarges passage_speed, passage_pressure, passage_peak and settling_steps of `found` by what each mouth with a given
/// inflow or a pressure drives through the passages up to an outlet, and by what all given inflows into one piece of
/// pore space drive together. Outlets are the mouths that yield or draw. `piece`: of each node (pieces_of).
void look_for_passages(const Scene& scene, const NoSlipWalls& walls, const FluidPicture& picture,
                       const std::vector<Mouth>& mouths, const std::vector<int>& piece, const LatticeUnits& units,
                       FlowPaths& found);

}  // namespace vug
