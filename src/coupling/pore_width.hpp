#pragma once
// How wide the pores are, on the host.
#include "coupling/fluid_picture.hpp"
#include "io/scene.hpp"

#include <cstddef>
#include <vector>

namespace vug {

/// The no-slip walls of a scene: rock, and what of the sides is a wall that does not slide. It points into the picture.
class NoSlipWalls {
 public:
  NoSlipWalls(const FluidPicture& picture, const Scene& scene);
  /// Whether a node is beside one: across a face, or across a corner of rock as well.
  bool hold(std::size_t n, JoinedBy by = JoinedBy::corners) const;

 private:
  const FluidPicture& picture_;
  std::vector<bool> beside_side_;  ///< (node)
};

/// (node) The largest width, cells, that a pore with this node in its middle may have: 2 d + 2 for a way of d faces to
/// the nearest node with a no-slip wall at a face; 0 in rock and where no such wall holds the fluid. Between two walls
/// along an axis that is the true width, or one more; beside a single wall twice the depth of the layer.
std::vector<int> pore_widths(const FluidPicture& picture, const NoSlipWalls& walls);

}  // namespace vug
