#pragma once
// Boxes of solid and fluid, drawn by hand.
#include "reactive_box.hpp"

#include <string>
#include <vector>

namespace vug::reference {

using Box = ReactiveBox<D2Q5, double>;

/// Rows of '.', fluid, and '#', solid; the first row is the top.
inline Box box_of(const std::vector<std::string>& rows, double C0 = 0) {
  const int ny = static_cast<int>(rows.size()), nx = static_cast<int>(rows[0].size());
  Box box(
      nx, ny, [&](int x, int y) { return rows[ny - 1 - y][x] == '#'; }, solute_parameters(0.1), C0);
  box.wall.molar_volume = 1;
  return box;
}

}  // namespace vug::reference
