#pragma once
// The strip of nodes that a pathway along a straight line opens: as wide as its aperture asks for, in whole cells.
#include "kernels/base/lattice.hpp"
#include "kernels/flow/slit.hpp"

#include <array>
#include <vector>

namespace vug {

/// Aperture (cells) of the slot that conducts as well as a strip with n nodes across it in every column, for a line
/// that rises by 0 <= slope <= 1 per column. n = 1 is the cells that the line passes through, which are 1 + slope per
/// column.
double strip_aperture(int n, double slope);

/// A node of a strip.
struct StripNode {
  int node;         ///< row by row without halo
  double aperture;  ///< the least with which the pathway opens it, cells
};

/// The nodes that a pathway of `aperture` >= 1 cells along the segment a-b (m) opens, in order of node. From an
/// aperture of 1 on these are the cells that the segment passes through; then the next node across it opens column by
/// column, from the middle of the segment to its ends, at the aperture whose slot conducts as well as the columns in
/// series, with what the ends of their run cost. So w cells along an axis are w rows wherever the line lies (of two as
/// near to it the lower or left first), every strip is one piece across faces of cells, and the conductivity hardly
/// depends on the direction (docs/model.md). Ends are round: strips that share an end meet there.
std::vector<StripNode> strip_nodes(const std::array<double, 2>& a, const std::array<double, 2>& b, double aperture,
                                   const Lattice& lattice, double spacing);

}  // namespace vug
