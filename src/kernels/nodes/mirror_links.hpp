#pragma once
// The surface of an opening as a mirror: which of its links change places in it.
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// (link) The link that each of the `links` of D2Q9 through one stretch of a side, or into one opening, changes places
/// with; -1 for none. A mirror half way along the straight links sends what leaves along a diagonal to the node beside:
///   - a straight link is its own image; so is a diagonal one where the surface has a corner, for want of a mirror;
///   - two diagonal links that cross beside a flat piece of the surface are images of each other;
///   - a diagonal link whose image would start in rock, behind a wall or beyond the end of the stretch has none.
/// On a staircase, a surface with more steps than a rectangle has corners, every link is its own image: mirrors that
/// stand at right angles to each other would turn all velocity round and let nothing through.
IndexList find_mirror_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links);

}  // namespace vug
