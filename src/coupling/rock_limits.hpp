#pragma once
// Whether the triangles resolve what breaks.
#include "coupling/limits.hpp"
#include "dem/mechanics.hpp"

namespace vug {

/// Mean edge of the bonds against the length over which cracks soften, of the material where it is shortest.
Limit limit_of_edges(const Mechanics& rock);

}  // namespace vug
