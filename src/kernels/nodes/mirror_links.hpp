#pragma once
// The surface of an opening as a mirror: which of its links are images of each other.
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// (link) The mirror image of each of the `links` of D2Q9 through one stretch of a side or into one opening; -1 if
/// there is none. A mirror half way along the straight links reflects what leaves along a diagonal to the node beside:
///   - a straight link is its own image; so is a diagonal one at a corner of the surface, where there is no mirror;
///   - two diagonal links that cross beside a flat piece of the surface are images of each other;
///   - a diagonal link whose image would start in rock, behind a wall or beyond the end of the stretch has none.
/// On a staircase, a surface with more steps than a rectangle has corners, every link is its own image: mirrors at
/// right angles to each other would reverse the whole velocity and let nothing through.
IndexList find_mirror_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links);

}  // namespace vug
