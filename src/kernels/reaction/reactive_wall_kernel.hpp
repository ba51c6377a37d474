#pragma once
// The kernel behind set_conductances, for code with a rate policy of its own.
#include "kernels/launch/launch.hpp"
#include "kernels/reaction/reactive_wall_step.hpp"

namespace vug {

/// Sets the conductance of a link: J = conductance (A1 - q A2) by the kinetic law, rate = conductance (C1 - q C2) by
/// the paper's (paper_wall). For an order other than 1 it is the rate constant itself.
template <class T, class Set, class Rock, class Rate>
struct SetConductance {
  ReactiveWallLaw law;
  Rock rock;
  T D1, D2, ahead;
  Rate rate;
  LinkArea area;
  IndexList surface, fluid_node;
  int capacity;
  ReactiveLinks<T> links;

  /// The nodes at both ends of a link.
  KOKKOS_FORCEINLINE_FUNCTION int solid(int l) const { return surface(links.surface_of(l)); }
  KOKKOS_FORCEINLINE_FUNCTION int fluid(int l) const {
    return fluid_node(links.slot(l) - Set::opposite(links.direction_of(l)) * capacity);
  }
  /// What is read from scattered places: the share of true area here; the temperature of the face, by `rate`.
  KOKKOS_FORCEINLINE_FUNCTION double share(int l) const {
    return area.share(links.surface_of(l), links.direction_of(l));
  }
  /// What is computed from these.
  KOKKOS_FORCEINLINE_FUNCTION void set(int l, double kelvin, double share) const {
    const T now = T(rate.at(solid(l), kelvin) * share);
    const T led = now + ahead * (now - links.rate(l));
    const T k = led < now / 2 ? now / 2 : led > 2 * now ? 2 * now : led;
    links.rate(l) = now;
    if (!rock.first_order(links, l)) {
      links.conductance(l) = k;
      return;
    }
    const T q = rock.equilibrium(links, l), y = rock.yield(links, l);
    links.conductance(l) =
        law == ReactiveWallLaw::kinetic ? kinetic_conductance(k, q, y) : paper_conductance(k, q, D1, D2, y);
  }
  KOKKOS_FUNCTION void operator()(int l) const { set(l, rate.kelvin(solid(l), fluid(l)), share(l)); }
};

/// A block of links on a host: all is looked up first, one by one, so that what is computed from it vectorises.
template <class Body>
struct SetConductancesOfBlock {
  Body body;
  KOKKOS_FUNCTION void operator()(int first, int last) const {
    const Body local = body;
    int solid[nodes_per_block], fluid[nodes_per_block];
    double kelvin[nodes_per_block], share[nodes_per_block];
    const int count = last - first;
    for (int i = 0; i < count; ++i) {
      solid[i] = local.solid(first + i);
      fluid[i] = local.fluid(first + i);
      local.rate.announce(solid[i], fluid[i]);
      local.area.announce(local.links.surface_of(first + i));
    }
    for (int i = 0; i < count; ++i) {
      kelvin[i] = local.rate.kelvin(solid[i], fluid[i]);
      share[i] = local.share(first + i);
    }
    VUG_VECTORISE
    for (int i = 0; i < count; ++i) local.set(first + i, kelvin[i], share[i]);
  }
};

template <class Set, class T, class Rate>
void set_conductances(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const ReactiveWall& wall,
                      const Rate& rate, const VectorField<double>& normal, const ReactiveLinks<T>& links,
                      double ahead) {
  visit_rock<T, Set>(wall, [&](const auto& rock) {
    using Body = SetConductance<T, Set, std::decay_t<decltype(rock)>, Rate>;
    const Body body{wall.law, rock,         T(wall.D_reactant), T(wall.D_product), T(ahead), rate,
                    {normal}, surface.node, nodes.node,         nodes.capacity,    links};
    const char* label = "vug::reactive_wall::conductances";
    if constexpr (runs_on_host)
      for_each_block(exec, label, links.share(), SetConductancesOfBlock<Body>{body}, block_of_list(links.count));
    else
      for_each_node(exec, label, links.share(), body);
  });
}

}  // namespace vug
