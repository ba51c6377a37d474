#pragma once
// The cells in an interval, and the cell that contains a point. A cell belongs to the interval that contains its
// centre. A centre on the lower bound of an interval belongs to it, one on the upper bound does not, so that an
// interval n cells long contains n cells wherever its bounds are.
#include <array>
#include <cmath>

namespace vug {

/// Points nearer than this to the centre or the boundary of a cell count as on it, so that rounding has no effect.
/// Cells.
constexpr double tie = 1e-9;

/// A coordinate in cells, moved to the centre or the boundary of a cell when it is within `tie` of it.
inline double snapped(double at) {
  const double nearest = std::round(2 * at) / 2;
  return std::abs(at - nearest) < tie ? nearest : at;
}

/// A point in cells.
inline std::array<double, 2> point_in_cells(const std::array<double, 2>& at, double spacing) {
  return {snapped(at[0] / spacing), snapped(at[1] / spacing)};
}

/// The cell that contains a coordinate (cells); on the boundary between two cells, the higher one.
inline int cell_of(double at) {
  return static_cast<int>(std::floor(snapped(at)));
}

/// The first cell with its centre at or beyond `at` (cells): [low, high) contains the cells first_cell(low) to
/// first_cell(high) - 1.
inline int first_cell(double at) {
  return static_cast<int>(std::ceil(snapped(at) - 0.5));
}

}  // namespace vug
