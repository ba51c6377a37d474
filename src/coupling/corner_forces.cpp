#include "coupling/corner_forces.hpp"

namespace vug {

bool crosses(const Stretch& side, const Lattice& lattice, int node, int direction) {
  const int outward = static_cast<int>(side.side);
  const int across = D2Q9::c(direction, 0) * D2Q9::c(outward, 0) + D2Q9::c(direction, 1) * D2Q9::c(outward, 1);
  const int x = lattice.x(node), y = lattice.y(node), along = is_upright(side.side) ? y : x;
  const bool beside = side.side == Side::left     ? x == 0
                      : side.side == Side::right  ? x == lattice.nx - 1
                      : side.side == Side::bottom ? y == 0
                                                  : y == lattice.ny - 1;
  return !side.opening && across > 0 && beside && along >= side.first && along <= side.last;
}

template <class T>
std::vector<CornerForce> corner_forces(const Lattice& lattice, const std::vector<StretchLinks>& boundaries,
                                       const StretchLinks& own, const OnHost<IndexList>& node,
                                       const OnHost<ScalarField<T>>& out, const OnHost<ScalarField<T>>& in) {
  std::vector<CornerForce> found;
  if (own.stretch.opening) return found;
  const auto at = on_host(own.links.fluid);
  const auto direction = on_host(own.links.direction);
  for (int link = 0; link < own.links.count; ++link) {
    const int n = node(at(link)), q = direction(link);
    for (const StretchLinks& other : boundaries) {
      if (is_upright(other.stretch.side) == is_upright(own.stretch.side) ||
          other.stretch.conditions.flow.kind == FlowBoundaryKind::periodic || !crosses(other.stretch, lattice, n, q))
        continue;
      const int axis = is_upright(other.stretch.side) ? 0 : 1;
      const double momentum = static_cast<double>(out(link)) + static_cast<double>(in(link));
      found.push_back(
          {&own.stretch, &other.stretch, axis, momentum * D2Q9::c(q, axis), {lattice.x(n) + 0.5, lattice.y(n) + 0.5}});
    }
  }
  return found;
}

VUG_COMPILE_FOR_NUMBERS(corner_forces)

}  // namespace vug
