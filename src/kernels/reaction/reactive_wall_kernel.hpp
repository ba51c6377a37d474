#pragma once
// The kernel behind set_conductances, for whoever brings a rate policy of their own.
#include "kernels/launch/launch.hpp"
#include "kernels/reaction/reactive_wall.hpp"

namespace vug {

/// Constants of a rate that are the same at all walls: 1/K_eq at a solid node, first order.
template <class T>
struct SameConstants {
  T q;
  KOKKOS_FORCEINLINE_FUNCTION T equilibrium(int) const { return q; }
  KOKKOS_FORCEINLINE_FUNCTION bool first_order(int) const { return true; }
};
/// Those of minerals.
template <class T>
struct MineralConstants {
  MineralRates minerals;
  KOKKOS_FORCEINLINE_FUNCTION T equilibrium(int node) const { return T(minerals.at(node).inverse_equilibrium); }
  KOKKOS_FORCEINLINE_FUNCTION bool first_order(int node) const { return minerals.at(node).order == 1; }
};

/// J = conductance (A1 - q A2) by the kinetic law, rate = conductance (C1 - q C2) by the paper's
/// (paper_wall); of another order the rate constant itself.
template <class T, class Set, class Constants, class Rate, class Area>
struct SetConductance {
  ReactiveWallLaw law;
  Constants constants;
  T D1, D2, ahead;
  Rate rate;
  Area area;
  IndexList surface, fluid_node;
  int capacity;
  ReactiveLinks<T> links;

  KOKKOS_FUNCTION void operator()(int l) const {
    const int s = links.root(l) / 8, along = links.root(l) % 8 + 1;
    const int fluid = links.slot(l) - Set::opposite(along) * capacity;
    const T now = T(rate(surface(s), fluid_node(fluid)) * area.share(s, along));
    const T led = now + ahead * (now - links.rate(l));
    const T k = led < now / 2 ? now / 2 : led > 2 * now ? 2 * now : led;
    links.rate(l) = now;
    if (!constants.first_order(surface(s))) {
      links.conductance(l) = k;
      return;
    }
    const T q = constants.equilibrium(surface(s));
    links.conductance(l) =
        law == ReactiveWallLaw::kinetic ? kinetic_conductance(k, q) : paper_conductance(k, q, D1, D2);
  }
};

template <class Set, class T, class Rate>
void set_conductances(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ReactiveWall& wall,
                      const Rate& rate, const VectorField<double>& normal, const ReactiveLinks<T>& links,
                      double ahead) {
  const auto launch = [&](const auto& constants) {
    with_link_area(normal, [&](const auto& area) {
      using Body = SetConductance<T, Set, std::decay_t<decltype(constants)>, Rate, std::decay_t<decltype(area)>>;
      for_each_node(exec, "vug::reactive_wall::conductances", links.share(),
                    Body{wall.law, constants, T(wall.D_reactant), T(wall.D_product), T(ahead), rate, area, surface.node,
                         nodes.node, nodes.capacity, links});
    });
  };
  if (wall.minerals.given())
    launch(MineralConstants<T>{wall.minerals});
  else
    launch(SameConstants<T>{T(wall.inverse_equilibrium)});
}

}  // namespace vug
