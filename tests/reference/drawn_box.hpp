#pragma once
// Boxes of solid and fluid, drawn by hand.
#include "reactive_box.hpp"
#include "support/host_copy.hpp"

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

/// Concentration of acid at node (x, y), fluid.
inline double concentration(const Box& box, int x, int y) {
  const int i = test::host_copy(box.nodes.index)(box.lattice.node(x, y));
  const auto h = test::host_copy(box.acid.h);
  double C = 0;
  for (int q = 0; q < 5; ++q) C += h(q * box.nodes.capacity + i);
  return C;
}

}  // namespace vug::reference
