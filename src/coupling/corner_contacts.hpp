#pragma once
// Places where pores touch only at a corner: the flow passes there, heat and solutes on D2Q5 do not.
#include "coupling/fluid_picture.hpp"
#include "coupling/mouths.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace vug {

/// Number of places where two fluid nodes touch only at a corner, between two rock nodes, and flow can pass from one to
/// the other: their fluid reaches two mouths or is driven by a force or a sliding wall, and neither lies in a dead end
/// that is joined to the rest at that place alone.
std::size_t corner_contacts(const Scene& scene, const FluidPicture& picture, const std::vector<Mouth>& mouths);

/// A warning where the flow of a picture or of shapes passes such places and carries heat or solutes that cannot, and
/// where such places alone join one side to another; otherwise, and for the pathways of [rock], empty.
std::string remark_on_corners(const Scene& scene, const FluidPicture& picture, const std::vector<Mouth>& mouths);

}  // namespace vug
