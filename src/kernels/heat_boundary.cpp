#include "kernels/heat_boundary.hpp"

#include "kernels/launch.hpp"

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

}  // namespace

/// One link that crosses a side, as its law sees it.
template <class T>
struct SideLink {
  T leaving;   ///< A, the population that leaves through it, or that a mirror sends back through it
  T inward;    ///< the node's own population of the opposite direction
  T weight;    ///< w of the velocity set
  T share;     ///< of what enters at the node, of a mineral over its heat capacity
  bool solid;  ///< of the one solid that there is
};

/// What a boundary asks of its nodes: fluid and one solid.
template <class T>
struct TwoKinds {
  double capacity_ratio;
  Kokkos::View<const std::uint8_t*> kind;
  KOKKOS_FORCEINLINE_FUNCTION bool solid(int node) const { return kind(node) != 0; }
  KOKKOS_FORCEINLINE_FUNCTION T share(int, T share) const { return share; }
  KOKKOS_FORCEINLINE_FUNCTION double capacity(int node) const { return kind(node) ? capacity_ratio : 1; }
};
/// Fluid and minerals.
template <class T>
struct ManyKinds {
  Kokkos::View<const double*> capacities;
  Kokkos::View<const std::uint8_t*> kind;
  KOKKOS_FORCEINLINE_FUNCTION bool solid(int) const { return false; }
  KOKKOS_FORCEINLINE_FUNCTION T share(int node, T share) const { return share / static_cast<T>(capacity(node)); }
  KOKKOS_FORCEINLINE_FUNCTION double capacity(int node) const { return capacities(kind(node)); }
};

/// in = A + share q / c.
template <class T>
struct FluxIn {
  static constexpr bool mirrors = true;
  T fluid_flux, solid_flux;
  KOKKOS_FUNCTION T operator()(const SideLink<T>& link) const {
    return link.leaving + link.share * (link.solid ? solid_flux : fluid_flux);
  }
};

/// in = A + share h (theta_out - (in + A) / 2w) / c, solved for what comes in: Newton's law of cooling with the
/// temperature that the wall plane then has. Large h: the temperature is given; none: nothing passes.
template <class T>
struct ConvectionIn {
  static constexpr bool mirrors = true;
  T outside, fluid_transfer, solid_transfer;
  KOKKOS_FUNCTION T operator()(const SideLink<T>& link) const {
    const T passed = link.share * (link.solid ? solid_transfer : fluid_transfer), held = passed / (2 * link.weight);
    return (link.leaving * (1 - held) + passed * outside) / (1 + held);
  }
};

/// in = -A + 2 w theta_wall (half-way anti-bounce-back).
template <class T>
struct TemperatureIn {
  static constexpr bool mirrors = false;
  T twice_wall_temperature;
  KOKKOS_FUNCTION T operator()(const SideLink<T>& link) const {
    return link.weight * twice_wall_temperature - link.leaving;
  }
};

/// in = the node's own inward population.
template <class T>
struct OutflowIn {
  static constexpr bool mirrors = false;
  KOKKOS_FUNCTION T operator()(const SideLink<T>& link) const { return link.inward; }
};

/// Writes the populations that arrive at one node through a side into the halo and returns the energy they bring in,
/// the sum of c (in - A). `Law` maps a SideLink to what arrives.
template <class T, class Set, class Law, class Kinds>
struct FillSide {
  Law law;
  Kinds kinds;
  Lattice lattice;
  int first, count, stride, outward;
  bool whole, lower_corner, upper_corner;  ///< a whole side; the corners that are its
  Kokkos::View<const std::uint8_t*> solid;
  ScalarField<T> g;

  KOKKOS_FORCEINLINE_FUNCTION static int along(int outward, int q) {
    return Set::c(outward, 0) == 0 ? Set::c(q, 0) : Set::c(q, 1);
  }
  KOKKOS_FORCEINLINE_FUNCTION static bool crosses(int outward, int q) {
    return Set::c(q, 0) * Set::c(outward, 0) + Set::c(q, 1) * Set::c(outward, 1) == 1;
  }
  /// True where a diagonal link leaves through a corner that is another side's.
  KOKKOS_FUNCTION bool lost_corner(int node, int q) const {
    const int step = along(outward, q);
    return solid(node + step * stride) == outside_lattice && !(step < 0 ? lower_corner : upper_corner);
  }
  /// What leaves and will arrive through the diagonal link q of a node: with a mirror, what leaves the next node of the
  /// same kind and of this stretch by the link that crosses q.
  KOKKOS_FUNCTION T leaving(int item, int node, int q) const {
    const int step = along(outward, q), plane = lattice.size();
    const int next = node + step * stride;
    const bool beside = whole || (item + step >= 0 && item + step < count);
    if (!Law::mirrors || step == 0 || !beside || kinds.kind(next) != kinds.kind(node)) return g(q * plane + node);
    int crossing = 5;
    while (crossing == q || !crosses(outward, crossing)) ++crossing;
    return g(crossing * plane + next);
  }
  KOKKOS_FUNCTION double fill(int item, int node, int q, T share) const {
    const int plane = lattice.size(), back = Set::opposite(q);
    const SideLink<T> link{leaving(item, node, q), g(back * plane + node), static_cast<T>(Set::w(q)),
                           kinds.share(node, share), kinds.solid(node)};
    const T arriving = law(link);
    g(back * plane + node + lattice.offset(q)) = arriving;
    return static_cast<double>(arriving) - static_cast<double>(link.leaving);
  }
  KOKKOS_FUNCTION double operator()(int item) const {
    const int node = first + item * stride;
    if (solid(node) > 1) return 0;
    double entered = 0;
    T straight_share = 1;
    for (int q = 5; q < Set::Q; ++q) {
      if (!crosses(outward, q) || lost_corner(node, q)) continue;
      const T share = static_cast<T>(6 * Set::w(q));
      straight_share -= share;
      entered += fill(item, node, q, share);
    }
    entered += fill(item, node, outward, straight_share);
    return kinds.capacity(node) * entered;
  }
};

/// As FillSide for one link into an opening, whose node there takes what arrives.
template <class T, class Set, class Law, class Kinds>
struct FillOpening {
  Law law;
  Kinds kinds;
  int plane;
  Kokkos::View<const int*> node, beyond;
  Kokkos::View<const std::uint8_t*> direction;
  Kokkos::View<const double*> area;
  ScalarField<T> g;
  KOKKOS_FUNCTION double operator()(int item) const {
    const int n = node(item), q = direction(item), back = Set::opposite(q);
    const SideLink<T> link{g(q * plane + n), g(back * plane + n), static_cast<T>(Set::w(q)),
                           kinds.share(n, static_cast<T>(area(item))), kinds.solid(n)};
    const T arriving = law(link);
    g(back * plane + beyond(item)) = arriving;
    return kinds.capacity(n) * (static_cast<double>(arriving) - static_cast<double>(link.leaving));
  }
};

namespace {

/// visit(Set{}, the kinds of the nodes).
template <class T, class Visit>
void visit_kinds(const HeatFields<T>& fields, const Visit& visit) {
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    if (fields.matter.given())
      visit(set, ManyKinds<T>{fields.matter.capacity, fields.matter.of_node});
    else
      visit(set, TwoKinds<T>{fields.rates.capacity_ratio, fields.solid});
  });
}

template <class T, class Law>
void launch(const Exec& exec, const HeatFields<T>& fields, const HeatSide& side, const Law& law) {
  const Lattice& lattice = fields.lattice;
  const auto [origin, stride] = side_nodes(lattice, side.side);
  const int start = origin + side.first * stride, step = stride, count = side.last - side.first + 1;
  const bool whole = count == side_length(lattice, side.side);
  visit_kinds(fields, [&](auto set, const auto& kinds) {
    using Body = FillSide<T, decltype(set), Law, std::decay_t<decltype(kinds)>>;
    const Body body{law,   kinds,           lattice,         start,        count,   step, outward(side.side),
                    whole, side.corners[0], side.corners[1], fields.solid, fields.g};
    add_per_block(exec, "vug::heat::fill_side", count, body, side.energy_in);
  });
}

template <class T, class Law>
void launch(const Exec& exec, const HeatFields<T>& fields, const HeatOpening& opening, const Law& law) {
  const DenseLinks& links = opening.links;
  visit_kinds(fields, [&](auto set, const auto& kinds) {
    using Body = FillOpening<T, decltype(set), Law, std::decay_t<decltype(kinds)>>;
    const Body body{law, kinds, fields.lattice.size(), links.node, links.beyond, links.direction, links.area, fields.g};
    add_per_block(exec, "vug::heat::fill_opening", links.count, body, opening.energy_in);
  });
}

/// Launches the law of a side's or an opening's condition.
template <class T, class Boundary>
void fill(const Exec& exec, const HeatFields<T>& fields, const Boundary& boundary) {
  switch (boundary.condition) {
    case HeatCondition::adiabatic:
      return launch(exec, fields, boundary, FluxIn<T>{0, 0});
    case HeatCondition::temperature:
      return launch(exec, fields, boundary, TemperatureIn<T>{static_cast<T>(2 * boundary.value)});
    case HeatCondition::flux:
      return launch(
          exec, fields, boundary,
          FluxIn<T>{static_cast<T>(boundary.value), static_cast<T>(boundary.value / fields.rates.capacity_ratio)});
    case HeatCondition::convection:
      return launch(exec, fields, boundary,
                    ConvectionIn<T>{static_cast<T>(boundary.value), static_cast<T>(boundary.transfer),
                                    static_cast<T>(boundary.transfer / fields.rates.capacity_ratio)});
    case HeatCondition::outflow:
      return launch(exec, fields, boundary, OutflowIn<T>{});
  }
}

}  // namespace

template <class T>
void fill_heat_side(const Exec& exec, const HeatFields<T>& fields, const HeatSide& side) {
  fill(exec, fields, side);
}

template <class T>
void fill_heat_opening(const Exec& exec, const HeatFields<T>& fields, const HeatOpening& opening) {
  fill(exec, fields, opening);
}

template <class T>
HeatOpening make_heat_opening(const Exec& exec, const HeatFields<T>& fields, const Kokkos::View<NodeType*>& type,
                              std::array<bool, 2> periodic, const Opening& opening, HeatCondition condition,
                              double value) {
  const int directions = visit_velocity_set(fields.velocity_set, [](auto set) { return decltype(set)::Q; });
  HeatOpening made{
      find_dense_opening_links(exec, fields.lattice, periodic, type, opening, directions), condition, value, {}, 0};
  made.energy_in = ScalarField<double>("vug::heat::energy_in", block_count(made.links.count));
  return made;
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

#define VUG_INSTANTIATE(T)                                                                                  \
  template void fill_heat_side(const Exec&, const HeatFields<T>&, const HeatSide&);                         \
  template void fill_heat_opening(const Exec&, const HeatFields<T>&, const HeatOpening&);                   \
  template HeatOpening make_heat_opening(const Exec&, const HeatFields<T>&, const Kokkos::View<NodeType*>&, \
                                         std::array<bool, 2>, const Opening&, HeatCondition, double);       \
  template void join_heat_sides(const Exec&, const HeatFields<T>&, int)
VUG_INSTANTIATE(float);
VUG_INSTANTIATE(double);
#undef VUG_INSTANTIATE

}  // namespace vug
