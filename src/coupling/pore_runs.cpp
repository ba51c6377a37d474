#include "coupling/pore_runs.hpp"

#include <algorithm>
#include <limits>

namespace vug {

AxisEnds ends_of(const Scene& scene, int axis) {
  const BoundarySection& low = axis == 0 ? scene.left : scene.bottom;
  const BoundarySection& high = axis == 0 ? scene.right : scene.top;
  return {periodic_sides(scene)[axis], {is_open(low.flow), is_open(high.flow)}};
}

std::vector<double> widths_along(const AxisView& view, const AxisEnds& ends) {
  std::vector<double> width(view.picture.size(), 0);
  const int n = view.length();
  for (int line = 0; line < view.lines(); ++line) {
    int rock = -1;
    for (int k = 0; k < n && rock < 0; ++k)
      if (!view.is_fluid(line, k)) rock = k;
    const int start = ends.joined && rock >= 0 ? rock : 0;  // where lines are joined, no run begins in the middle
    for (int k = start; k < start + n;) {
      int end = k;
      while (end < start + n && view.is_fluid(line, end % n)) ++end;
      const bool first = !ends.joined && k == 0 && ends.open[0], last = !ends.joined && end == n && ends.open[1];
      const bool free = ends.joined ? rock < 0 : first && last;
      for (int m = k; m < end; ++m)
        width[view.node(line, m % n)] =
            free ? std::numeric_limits<double>::infinity() : (first || last ? 2.0 : 1.0) * (end - k);
      k = std::max(end, k + 1);
    }
  }
  return width;
}

std::vector<double> shorter_widths(const Scene& scene, const FluidPicture& picture) {
  std::vector<double> width = widths_along({picture, 0}, ends_of(scene, 0));
  const std::vector<double> other = widths_along({picture, 1}, ends_of(scene, 1));
  for (std::size_t n = 0; n < width.size(); ++n) width[n] = std::min(width[n], other[n]);
  return width;
}

}  // namespace vug
