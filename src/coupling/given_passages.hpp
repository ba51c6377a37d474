#pragma once
// What given velocities and rates mean in the passages behind them.
#include "coupling/flow_paths.hpp"
#include "coupling/mouths.hpp"
#include "coupling/pore_width.hpp"

#include <vector>

namespace vug {

/// Enlarges passage_speed, passage_pressure, passage_peak and settling_steps of `found` by what flows behind each mouth
/// with a given inflow, in or out, behind all of those that push into one piece of pore space and all that draw from
/// it, and behind what yields there; and settling_steps by what pressures drive. `piece`: of each node (pieces_of).
void look_for_passages(const Scene& scene, const NoSlipWalls& walls, const FluidPicture& picture,
                       const std::vector<Mouth>& mouths, const std::vector<int>& piece, const LatticeUnits& units,
                       FlowPaths& found);

}  // namespace vug
