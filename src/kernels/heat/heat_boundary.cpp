#include "kernels/heat/heat_boundary.hpp"

#include "base/require.hpp"
#include "kernels/heat/heat_conditions.hpp"
#include "kernels/heat/heat_kernels.hpp"
#include "kernels/launch/launch_lists.hpp"
#include "kernels/launch/row_launch.hpp"

#include <algorithm>
#include <type_traits>

namespace vug {

namespace {

/// Direction of the outward velocity of a side.
constexpr int outward(Side side) {
  return static_cast<int>(side);
}

/// First node of a side and the distance in memory along it.
struct SideNodes {
  int first, stride;
};

SideNodes side_nodes(const Lattice& lattice, Side side) {
  switch (side) {
    case Side::left:
      return {lattice.node(0, 0), lattice.pitch};
    case Side::right:
      return {lattice.node(lattice.nx - 1, 0), lattice.pitch};
    case Side::bottom:
      return {lattice.node(0, 0), 1};
    default:
      return {lattice.node(0, lattice.ny - 1), 1};
  }
}

/// The nodes of a stretch that lie in these rows, by their numbers along it.
Rows nodes_in_rows(const Lattice& lattice, const HeatSide& side, const Rows& rows) {
  const int nodes = side.last - side.first + 1, last_row = rows.first + rows.count - 1;
  if (side.side == Side::bottom || side.side == Side::top) {
    const int row = side.side == Side::bottom ? 0 : lattice.ny - 1;
    return {0, row >= rows.first && row <= last_row ? nodes : 0};
  }
  const int first = std::max(side.first, rows.first), last = std::min(side.last, last_row);
  return {first - side.first, std::max(last - first + 1, 0)};
}

}  // namespace

std::vector<int> nodes_of(const Lattice& lattice, const HeatSide& side) {
  const auto [origin, stride] = side_nodes(lattice, side.side);
  std::vector<int> nodes;
  for (int k = side.first; k <= side.last; ++k) nodes.push_back(origin + k * stride);
  return nodes;
}

/// Writes the populations that arrive at one node through a side into the halo and books the energy they bring in, the
/// sum of c (in - A). `Law` maps a SideLink to what arrives.
template <class T, class Law, class Links>
struct FillSide {
  using Set = typename Links::Set;
  Law law;
  SideEntry side;
  Links links;
  Kokkos::View<const std::uint8_t*> solid;

  KOKKOS_FORCEINLINE_FUNCTION static int along(int outward, int q) {
    return Set::c(outward, 0) == 0 ? Set::c(q, 0) : Set::c(q, 1);
  }
  KOKKOS_FORCEINLINE_FUNCTION static bool crosses(int outward, int q) {
    return Set::c(q, 0) * Set::c(outward, 0) + Set::c(q, 1) * Set::c(outward, 1) == 1;
  }
  /// True where a diagonal link leaves through a corner that belongs to another side.
  KOKKOS_FUNCTION bool lost_corner(int node, int q) const {
    const int step = along(side.outward, q);
    return solid(node + step * side.stride) == outside_lattice && !(step < 0 ? side.lower_corner : side.upper_corner);
  }
  /// On D2Q9: true where another side begins. An outflow subtracts no conduction there: between two that did, waves
  /// would grow (OutflowStability).
  KOKKOS_FUNCTION bool at_corner(int node) const {
    return solid(node - side.stride) == outside_lattice || solid(node + side.stride) == outside_lattice;
  }
  /// The population that leaves through link q of a node and determines what arrives. At a mirror, for a diagonal link,
  /// it is the one that leaves the next node of this stretch by the link that crosses q; of another kind of matter,
  /// what the law of links between kinds makes of the two. The fluid's outflow is no mirror, and rock beside it has
  /// none.
  KOKKOS_FUNCTION T leaving(int item, int node, int q) const {
    const int step = along(side.outward, q), plane = links.around.lattice.size();
    const int next = node + step * side.stride;
    const T own = links.g(q * plane + node);
    const bool beside = side.whole || (item + step >= 0 && item + step < side.count);
    if (!Law::mirrors || step == 0 || !beside || solid(next) > 1) return own;
    const bool alike = links.kinds.kind(next) == links.kinds.kind(node);
    if (!alike && Law::looks_inside) return own;
    int crossing = 5;
    while (crossing == q || !crosses(side.outward, crossing)) ++crossing;
    const T mirrored = links.g(crossing * plane + next);
    if (alike) return mirrored;
    const T here = static_cast<T>(links.kinds.capacity(node)), beyond = static_cast<T>(links.kinds.capacity(next));
    return links.rounding.sum(mirrored, conjugate_gain_of(mirrored, own, here, beyond), node);
  }
  KOKKOS_FUNCTION double fill(int item, int node, int q, T share) const {
    const T left = leaving(item, node, q), arriving = links.arriving(law, node, q, left, share, at_corner(node));
    links.g(Set::opposite(q) * links.around.lattice.size() + node + links.around.lattice.offset(q)) = arriving;
    return static_cast<double>(arriving) - static_cast<double>(left);
  }
  KOKKOS_FUNCTION void operator()(int ours) const {
    const int item = side.begin + ours, node = side.first + item * side.stride;
    if (solid(node) > 1) return;
    double entered = 0;
    T straight_share = 1;
    for (int q = 5; q < Set::Q; ++q) {
      if (!crosses(side.outward, q) || lost_corner(node, q)) continue;
      const T share = static_cast<T>(6 * Set::w(q));
      straight_share -= share;
      entered += fill(item, node, q, share);
    }
    entered += fill(item, node, side.outward, straight_share);
    side.entered[item] += links.kinds.capacity(node) * entered;
  }
};

/// All sides, each by its law.
template <class T, class Links>
struct FillSides {
  Links links;
  double capacity_ratio;
  Rows rows;
  Kokkos::View<const std::uint8_t*> solid;

  using Entry = SideEntry;
  int count(const HeatSide& side) const { return nodes_in_rows(links.around.lattice, side, rows).count; }
  Entry entry(const HeatSide& side) const {
    const auto [origin, stride] = side_nodes(links.around.lattice, side.side);
    const int nodes = side.last - side.first + 1;
    const bool whole = nodes == side_length(links.around.lattice, side.side);
    return {condition_of(side, capacity_ratio),
            origin + side.first * stride,
            nodes,
            nodes_in_rows(links.around.lattice, side, rows).first,
            stride,
            outward(side.side),
            whole,
            side.corners[0],
            side.corners[1]};
  }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const Entry& e, const Run& run) const {
    e.template visit<T>(links.rounding, [&](const auto& law) {
      run(FillSide<T, std::decay_t<decltype(law)>, Links>{law, e, links, solid});
    });
  }
};

template <class T>
void fill_heat_sides(const Exec& exec, const HeatFields<T>& fields, std::span<const HeatSide> sides,
                     const std::type_identity_t<HeatCrossing<T>>& crossing) {
  visit_links(fields, crossing, [&](const auto& links) {
    for_each_of_lists(exec, "vug::heat::fill_side", sides,
                      FillSides<T, std::decay_t<decltype(links)>>{
                          links, fields.rates.capacity_ratio, {fields.first_row, fields.rows}, fields.solid});
  });
}

/// Copies the populations that leave through one side to the halo beside the other.
template <class T, class Set>
struct JoinSides {
  int low, high, stride, beyond, plane, axis;
  ScalarField<T> g;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int bottom = low + item * stride;
    const int top = high + item * stride;
    for (int q = 1; q < Set::Q; ++q) {
      if (Set::c(q, axis) > 0) g(q * plane + bottom - beyond) = g(q * plane + top);
      if (Set::c(q, axis) < 0) g(q * plane + top + beyond) = g(q * plane + bottom);
    }
  }
};

template <class T>
void join_heat_sides(const Exec& exec, const HeatFields<T>& fields, int axis) {
  const Lattice& lattice = fields.lattice;
  const Side low = axis == 0 ? Side::left : Side::bottom;
  const Side high = axis == 0 ? Side::right : Side::top;
  const SideNodes nodes = side_nodes(lattice, low);
  const int last = side_nodes(lattice, high).first;
  // Across axis 1 the halo of axis 0 is copied as well: it brings what moves diagonally through two joined sides.
  const int halo = axis, count = (axis == 0 ? lattice.ny : lattice.nx) + 2 * halo;
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    for_each_node(exec, "vug::heat::join_sides", count,
                  JoinSides<T, decltype(set)>{nodes.first - halo, last - halo, nodes.stride,
                                              lattice.offset(outward(high)), lattice.size(), axis, fields.g});
  });
}

HeatSide make_heat_side(Side side, int first, int last, HeatCondition condition, double value) {
  if (first < 0 || last < first)
    throw InputError("heat: a stretch of a side from node " + std::to_string(first) + " to " + std::to_string(last));
  HeatSide made{side, first, last, condition, value, {}, {}, 0};
  made.energy_in = ScalarField<double>("vug::heat::energy_in", last - first + 1);
  return made;
}

namespace {

/// Precedence at a corner: the side of higher rank has its diagonal links; among equals, the left or right side.
int rank(const HeatSide& side) {
  const bool flux = side.condition == HeatCondition::flux || side.condition == HeatCondition::convection;
  return side.condition == HeatCondition::adiabatic ? 0 : flux ? 1 : 2;
}

}  // namespace

void assign_corners(const Lattice& lattice, std::vector<HeatSide>& sides) {
  const auto at_end = [&](const HeatSide& side, int end) {
    return end == 0 ? side.first == 0 : side.last == side_length(lattice, side.side) - 1;
  };
  for (HeatSide& upright : sides)
    for (HeatSide& flat : sides) {
      if (!is_upright(upright.side) || is_upright(flat.side)) continue;
      const int on_flat = upright.side == Side::left ? 0 : 1, on_upright = flat.side == Side::bottom ? 0 : 1;
      if (!at_end(upright, on_upright) || !at_end(flat, on_flat)) continue;
      flat.corners[on_flat] = rank(flat) > rank(upright);
      upright.corners[on_upright] = !flat.corners[on_flat];
    }
}

VUG_COMPILE_FOR_NUMBERS(fill_heat_sides)
VUG_COMPILE_FOR_NUMBERS(join_heat_sides)

}  // namespace vug
