#pragma once
// Which cells an interval holds, and in which a point lies. A cell belongs to what holds its centre; a centre on a bound belongs to the lower one,
// so that n cells between two bounds are n cells wherever the bounds lie.
#include <array>
#include <cmath>

namespace vug {

/// What lies nearer than this to a centre or a boundary of a cell lies on it: rounding decides nothing. Cells.
constexpr double tie = 1e-9;

/// A coordinate in cells, exactly on the centre or the boundary of a cell when it is as good as there.
inline double snapped(double at) {
  const double nearest = std::round(2 * at) / 2;
  return std::abs(at - nearest) < tie ? nearest : at;
}

/// A point in cells.
inline std::array<double, 2> point_in_cells(const std::array<double, 2>& at, double spacing) {
  return {snapped(at[0] / spacing), snapped(at[1] / spacing)};
}

/// The cell that a point lies in, in cells: on the boundary between two the higher one.
inline int cell_of(double at) {
  return static_cast<int>(std::floor(snapped(at)));
}

/// The first cell with its centre at or beyond `at` (cells): [low, high) holds the cells first_cell(low) to
/// first_cell(high) - 1.
inline int first_cell(double at) {
  return static_cast<int>(std::ceil(snapped(at) - 0.5));
}

}  // namespace vug
