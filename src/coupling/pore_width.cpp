#include "coupling/pore_width.hpp"

#include <algorithm>

namespace vug {

bool is_held_back(const FluidPicture& picture, const Scene& scene, std::size_t n, JoinedBy by) {
  const int x = static_cast<int>(n % picture.nx), y = static_cast<int>(n / picture.nx);
  const auto holds = [](const BoundarySection& side) {
    return side.flow.kind == FlowBoundaryKind::wall && side.flow.peak_speed() == 0;
  };
  if ((x == 0 && holds(scene.left)) || (x == picture.nx - 1 && holds(scene.right)) || (y == 0 && holds(scene.bottom)) ||
      (y == picture.ny - 1 && holds(scene.top)))
    return true;
  bool rock = false;
  const auto visit = [&](std::size_t m) { rock = rock || !picture.is_fluid(m); };
  if (by == JoinedBy::corners)
    picture.for_each_neighbour(n, visit);
  else
    picture.for_each_beside(n, visit);
  return rock;
}

std::vector<int> pore_widths(const FluidPicture& picture, const Scene& scene) {
  std::vector<int> width(picture.size(), 0);
  std::vector<std::size_t> front;
  for (std::size_t n = 0; n < picture.size(); ++n)
    if (picture.is_fluid(n) && is_held_back(picture, scene, n, JoinedBy::faces)) front.push_back(n);
  for (int reached = 2; !front.empty(); reached += 2) {
    std::vector<std::size_t> next;
    for (const std::size_t n : front) width[n] = reached;
    for (const std::size_t n : front)
      picture.for_each_beside(n, [&](std::size_t m) {
        if (width[m] > 0 || !picture.is_fluid(m)) return;
        width[m] = reached;  // only once in the next front
        next.push_back(m);
      });
    front = std::move(next);
  }
  return width;
}

}  // namespace vug
