#pragma once
// Whether the fluid that velocities press into a space finds a way out of it.
#include "coupling/flow_paths.hpp"
#include "coupling/mouths.hpp"

#include <vector>

namespace vug {

/// Reports pieces of fluid (`piece` of each node) without an outlet for the fluid that is pressed into them or drawn
/// out of them: throws InputError, or warns where rock opens. Warns where what is pressed in is drawn out at another
/// time, and where a shape pumps because a part of its moving surface is not in fluid.
void look_for_ways_out(const Scene& scene, const std::vector<Mouth>& mouths, const std::vector<int>& piece,
                       const LatticeUnits& units, bool rock_opens, FlowPaths& found);

}  // namespace vug
