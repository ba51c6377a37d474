#include "coupling/corner_forces.hpp"

#include <optional>

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

namespace {

/// Out + in of the straight link of a side at a node; none where there is no such link.
template <class T>
std::optional<double> straight_momentum(const std::vector<PassedLinks<T>>& boundaries, const OnHost<IndexList>& node,
                                        Side side, int at) {
  for (const PassedLinks<T>& b : boundaries) {
    if (b.boundary->stretch.opening || b.boundary->stretch.side != side) continue;
    for (int link = 0; link < b.boundary->links.count; ++link)
      if (b.direction(link) == static_cast<int>(side) && node(b.fluid(link)) == at) return b.momentum(link);
  }
  return std::nullopt;
}

/// The pressure on a side in the momentum of a link in direction q out of a corner's node; see corner_forces.
template <class T>
std::optional<double> pressure_at_corner(const std::vector<PassedLinks<T>>& boundaries, const Lattice& lattice,
                                         const OnHost<IndexList>& node, Side side, int at, int q) {
  const std::optional<double> here = straight_momentum(boundaries, node, side, at);
  if (!here) return std::nullopt;
  const int inward = is_upright(side) ? -D2Q9::c(q, 1) * lattice.pitch : -D2Q9::c(q, 0);
  const double beside = straight_momentum(boundaries, node, side, at + inward).value_or(*here);
  return (*here + (*here - beside) / 2) / 4;
}

}  // namespace

template <class T>
std::vector<CornerForce> corner_forces(const Lattice& lattice, const std::vector<PassedLinks<T>>& boundaries,
                                       const OnHost<IndexList>& node) {
  std::vector<CornerForce> found;
  for (const PassedLinks<T>& own : boundaries) {
    const Stretch& from = own.boundary->stretch;
    if (from.opening) continue;
    for (int link = 0; link < own.boundary->links.count; ++link) {
      const int n = node(own.fluid(link)), q = own.direction(link);
      for (const PassedLinks<T>& other : boundaries) {
        const Stretch& to = other.boundary->stretch;
        if (is_upright(to.side) == is_upright(from.side) || to.conditions.flow.kind == FlowBoundaryKind::periodic ||
            !crosses(to, lattice, n, q))
          continue;
        const double all = own.momentum(link);
        const double on_to = pressure_at_corner(boundaries, lattice, node, to.side, n, q).value_or(all);
        const double on_from = pressure_at_corner(boundaries, lattice, node, from.side, n, q).value_or(all);
        const int across = is_upright(to.side) ? 0 : 1;
        CornerForce force{&from, &to, {}, {lattice.x(n) + 0.5, lattice.y(n) + 0.5}};
        force.force[across] = D2Q9::c(q, across) * on_to;
        force.force[1 - across] = D2Q9::c(q, 1 - across) * (all - on_from);
        found.push_back(force);
      }
    }
  }
  return found;
}

VUG_COMPILE_FOR_NUMBERS(corner_forces)

}  // namespace vug
