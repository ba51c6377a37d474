#include "coupling/pore_width.hpp"

#include <utility>

namespace vug {

NoSlipWalls::NoSlipWalls(const FluidPicture& picture, const Scene& scene)
    : picture_(picture), beside_side_(picture.size(), false) {
  for (const Stretch& stretch : boundary_stretches(scene)) {
    const FlowBoundary& flow = stretch.conditions.flow;
    if (flow.kind != FlowBoundaryKind::wall || flow.peak_speed() != 0) continue;
    for (int i = stretch.first; i <= stretch.last; ++i) beside_side_[picture.beside(stretch.side, i)] = true;
  }
}

bool NoSlipWalls::hold(std::size_t n, JoinedBy by) const {
  if (beside_side_[n]) return true;
  bool rock = false;
  const auto visit = [&](std::size_t m) { rock = rock || !picture_.is_fluid(m); };
  if (by == JoinedBy::corners)
    picture_.for_each_neighbour(n, visit);
  else
    picture_.for_each_beside(n, visit);
  return rock;
}

std::vector<int> pore_widths(const FluidPicture& picture, const NoSlipWalls& walls) {
  std::vector<int> width(picture.size(), 0);
  std::vector<std::size_t> front;
  for (std::size_t n = 0; n < picture.size(); ++n)
    if (picture.is_fluid(n) && walls.hold(n, JoinedBy::faces)) front.push_back(n);
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
