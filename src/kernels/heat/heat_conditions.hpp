#pragma once
// The laws of heat_boundary.hpp: what arrives through a link, from what leaves.
#include "kernels/heat/heat_boundary.hpp"
#include "kernels/scalar/turning.hpp"

namespace vug {

/// Data of one link that crosses a side, for its law.
template <class T>
struct SideLink {
  int node;    ///< dense index
  T leaving;   ///< A, the population that leaves through it, or that a mirror sends back through it
  T inward;    ///< the node's own population of the opposite direction
  T weight;    ///< w of the velocity set
  T share;     ///< of what enters at the node; for minerals, over the heat capacity
  bool solid;  ///< the node is solid, where there is one solid
  bool rock;   ///< nothing flows at the node
  T paired;    ///< half of what leaves and comes in at equilibrium, over theta: w, but more where fluid crosses on D2Q9
  T slope;     ///< outflow_slope(tau) times the rise of the temperature from the node before; only if the law needs it
};

/// in = A + share q / c.
template <class T>
struct FluxIn {
  static constexpr bool mirrors = true, looks_inside = false, has_plane = false;
  T fluid_flux, solid_flux;
  Rounding<T> rounding;
  KOKKOS_FUNCTION T operator()(const SideLink<T>& link) const {
    return rounding.sum(link.leaving, link.share * (link.solid ? solid_flux : fluid_flux), link.node);
  }
};

/// in = A + share h (theta_out - (in + A) / 2 paired) / c, solved for what comes in: Newton's law of cooling with the
/// resulting temperature of the wall plane. With a large h the temperature is given; with h = 0 nothing passes.
template <class T>
struct ConvectionIn {
  static constexpr bool mirrors = true, looks_inside = false, has_plane = true;
  T outside, fluid_transfer, solid_transfer;
  Rounding<T> rounding;
  KOKKOS_FUNCTION T operator()(const SideLink<T>& link) const {
    const T passed = link.share * (link.solid ? solid_transfer : fluid_transfer), held = passed / (2 * link.paired);
    if constexpr (Rounding<T>::to_nearest)
      return (link.leaving * (1 - held) + passed * outside) / (1 + held);
    else
      return rounding.sum(link.leaving, passed * (outside - link.leaving / link.paired) / (1 + held), link.node);
  }
};

/// in = -A + 2 paired theta_wall (half-way anti-bounce-back).
template <class T>
struct TemperatureIn {
  static constexpr bool mirrors = false, looks_inside = false, has_plane = true;
  T twice_wall_temperature;
  KOKKOS_FUNCTION T operator()(const SideLink<T>& link) const {
    return link.paired * twice_wall_temperature - link.leaving;
  }
};

/// No conduction: in rock in = A. In fluid, which carries heat out, in = the node's own inward population less what it
/// conducts. The gradient at the node is half of that between the node before and this one, because there is none at
/// the plane of the side beyond. The inward population lacks (tau - 1) w of it, and so does the one that leaves. The
/// inward population unchanged would let heat out as if the fluid continued for 2 (tau - 1) nodes.
template <class T>
struct OutflowIn {
  static constexpr bool mirrors = true, looks_inside = true, has_plane = false;
  Rounding<T> rounding;
  KOKKOS_FUNCTION T operator()(const SideLink<T>& link) const {
    return link.rock ? link.leaving : rounding.sum(link.inward, -(link.weight * link.slope), link.node);
  }
};

/// SideLink::slope at the link q of a node; 0 where the node before is of another kind of matter.
template <class T, class Set, class Kinds>
KOKKOS_FUNCTION T slope_from(const Kinds& kinds, const ScalarField<T>& g, const DenseNeighbour& around, int node,
                             int q) {
  const int before = around.before(node, q);
  if (before < 0 || kinds.kind(before) != kinds.kind(node)) return 0;
  const int plane = around.lattice.size();
  const T rise = sum_of_populations<Set, T>(&g(node), plane) - sum_of_populations<Set, T>(&g(before), plane);
  return outflow_slope(1 / kinds.rate(node)) * rise;
}

/// SideLink::paired at the link q of a node.
template <class T, class Set>
KOKKOS_FUNCTION T paired_weight(const HeatCrossing<T>& crossing, int node, int q) {
  const T weight = static_cast<T>(Set::w(q));
  if (Set::Q == D2Q5::Q || crossing.index.extent(0) == 0 || crossing.index(node) < 0) return weight;
  return weight * crossing.fluid.template pair<Set>(crossing.index(node), q);
}

/// The condition of a side or an opening, and where what enters is booked.
struct ConditionOf {
  HeatCondition condition;
  double value, transfer, capacity_ratio;
  double* entered;  ///< (item)

  template <class T, class Visit>
  KOKKOS_FUNCTION void visit(const Rounding<T>& rounding, const Visit& visit) const {
    switch (condition) {
      case HeatCondition::adiabatic:
      case HeatCondition::periodic:  // has no links of its own
        return visit(FluxIn<T>{0, 0, rounding});
      case HeatCondition::temperature:
        return visit(TemperatureIn<T>{static_cast<T>(2 * value)});
      case HeatCondition::flux:
        return visit(FluxIn<T>{static_cast<T>(value), static_cast<T>(value / capacity_ratio), rounding});
      case HeatCondition::convection:
        return visit(ConvectionIn<T>{static_cast<T>(value), static_cast<T>(transfer),
                                     static_cast<T>(transfer / capacity_ratio), rounding});
      case HeatCondition::outflow:
        return visit(OutflowIn<T>{rounding});
    }
  }
};

template <class Boundary>
ConditionOf condition_of(const Boundary& boundary, double capacity_ratio) {
  return {boundary.condition, boundary.value, boundary.transfer, capacity_ratio, boundary.energy_in.data()};
}

/// A stretch of a side, from its first node; of `count` nodes those from number `begin` on are filled.
struct SideEntry : ConditionOf {
  int first, count, begin, stride, outward;
  bool whole, lower_corner, upper_corner;  ///< a whole side; the corners that belong to it
};

/// The links into an opening.
struct OpeningEntry : ConditionOf {
  const int *node, *beyond;
  const std::uint8_t* direction;
  const double* area;
};

/// The links that cross sides and openings. Laws get them one at a time.
template <class T, class Velocities, class Kinds>
struct HeatLinks {
  using Set = Velocities;
  Kinds kinds;
  DenseNeighbour around;
  HeatCrossing<T> through;
  ScalarField<T> g;
  Rounding<T> rounding;

  /// What arrives at a node through its link q by a law, when `leaving` leaves. With `level` the slope counts as 0.
  template <class Law>
  KOKKOS_FORCEINLINE_FUNCTION T arriving(const Law& law, int node, int q, T leaving, T share, bool level) const {
    SideLink<T> link{node,
                     leaving,
                     g(Set::opposite(q) * around.lattice.size() + node),
                     static_cast<T>(Set::w(q)),
                     kinds.share(node, share),
                     kinds.solid(node),
                     kinds.kind(node) != 0,
                     0,
                     0};
    if constexpr (Law::has_plane) link.paired = paired_weight<T, Set>(through, node, q);
    if constexpr (Law::looks_inside) link.slope = level ? 0 : slope_from<T, Set>(kinds, g, around, node, q);
    return law(link);
  }
};

/// Calls visit(links) with the HeatLinks of the fields.
template <class T, class Visit>
void visit_links(const HeatFields<T>& fields, const HeatCrossing<T>& crossing, const Visit& visit) {
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    visit_kinds(fields, [&](const auto& kinds) {
      visit(HeatLinks<T, decltype(set), std::decay_t<decltype(kinds)>>{
          kinds, {fields.lattice, fields.periodic}, crossing, fields.g, fields.rounding.at_links});
    });
  });
}

}  // namespace vug
