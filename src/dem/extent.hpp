#pragma once
// Bounding box of a rock.
#include "dem/assembly.hpp"

#include <algorithm>
#include <limits>

namespace vug {

/// Rectangle along the axes, m.
struct Extent {
  double left, bottom, right, top;
  double width() const { return right - left; }
  double height() const { return top - bottom; }
};

/// The smallest rectangle around all triangles.
inline Extent extent_of(const Assembly& assembly) {
  constexpr double far = std::numeric_limits<double>::infinity();
  Extent e{far, far, -far, -far};
  for (const auto& triangle : assembly.triangles)
    for (const int v : triangle) {
      const auto& [x, y] = assembly.vertices[v];
      e = {std::min(e.left, x), std::min(e.bottom, y), std::max(e.right, x), std::max(e.top, y)};
    }
  return e;
}

}  // namespace vug
