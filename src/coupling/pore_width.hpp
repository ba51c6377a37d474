#pragma once
// How wide the pores are, on the host.
#include "coupling/fluid_picture.hpp"
#include "io/scene.hpp"

#include <cstddef>
#include <vector>

namespace vug {

/// Whether fluid at a node is beside a no-slip wall: rock across a face, or across a corner as well, or a side that is
/// a wall and does not slide.
bool is_held_back(const FluidPicture& picture, const Scene& scene, std::size_t n, JoinedBy by = JoinedBy::corners);

/// (node) The largest width, cells, that a pore with this node in its middle may have: 2 d + 2 for a way of d faces to
/// the nearest node with a no-slip wall at a face; 0 in rock and where no such wall holds the fluid. Between two walls
/// along an axis that is the true width, or one more; beside a single wall twice the depth of the layer.
std::vector<int> pore_widths(const FluidPicture& picture, const Scene& scene);

}  // namespace vug
