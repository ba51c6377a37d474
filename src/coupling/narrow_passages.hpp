#pragma once
// Passages of so few cells that the collision of the flow decides how much they carry.
#include "coupling/fluid_picture.hpp"
#include "io/scene.hpp"
#include "io/units.hpp"

#include <string>
#include <vector>

namespace vug {

/// Warnings where flow.collision lets through less than half of what flows between plates as far apart
/// (kernels/flow/mrt.hpp): for fluid nodes in passages one cell wide, and for cracks narrower than a cell, whose drag
/// takes for granted that the row of nodes carries what `trt` lets through.
std::vector<std::string> remarks_on_narrow_passages(const Scene& scene, const FluidPicture& picture,
                                                    const LatticeUnits& units);

}  // namespace vug
