#pragma once
// The strip of nodes that a pathway along a straight line opens, as wide as its aperture requires, in whole cells.
#include "base/lattice.hpp"
#include "coupling/slit.hpp"

#include <array>
#include <vector>

namespace vug {

/// Aperture (cells) of the slot that conducts as much as a strip with n nodes in every column, for a line that rises by
/// 0 <= slope <= 1 per column. n = 1 stands for the cells through which the line passes, 1 + slope per column.
double strip_aperture(int n, double slope);

/// A node of a strip.
struct StripNode {
  int node;         ///< row by row without halo
  double aperture;  ///< smallest aperture at which the pathway opens it, cells
};

/// The nodes that a pathway of `aperture` >= 1 cells along the segment a-b (m) opens, in order of node. From an
/// aperture of 1 on these are the cells through which the segment passes. Then the next node across it opens column by
/// column, from the middle of the segment to its ends. A column opens at the aperture of the slot that conducts as much
/// as the columns in series, including the losses at the ends of their run. Hence w cells along an axis are w rows
/// wherever the line lies (of two equally near ones the lower or left one first), every strip is connected across faces
/// of cells, and its conductivity hardly depends on the direction (docs/model.md). Ends are round: strips with a common
/// end meet there.
std::vector<StripNode> strip_nodes(const std::array<double, 2>& a, const std::array<double, 2>& b, double aperture,
                                   const Lattice& lattice, double spacing);

}  // namespace vug
