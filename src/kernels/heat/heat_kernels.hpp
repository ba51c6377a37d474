#pragma once
// The laws of the heat step, one node each.
#include "base/unroll.hpp"
#include "kernels/heat/heat.hpp"
#include "kernels/scalar/rounding.hpp"
#include "kernels/scalar/scalar_equilibrium.hpp"

namespace vug {

/// Reflection r = (1 - sigma) / (1 + sigma) of a link between fluid and solid, sigma = (rho cp)_s / (rho cp)_f.
KOKKOS_FORCEINLINE_FUNCTION constexpr double interface_reflection(double capacity_ratio) {
  return (1 - capacity_ratio) / (1 + capacity_ratio);
}

/// What a link adds to the population that arrives through it: in = pulled + r (s_nb - s_x) (own - pulled), where
/// `pulled` left the neighbour for this node, `own` left this node for the neighbour in the same step, and s is 1 in
/// solid, 0 in fluid. Between unlike nodes this is Li, Chen, Mei & Klausner's half-link condition: into fluid
/// [(1 - sigma) own + 2 sigma pulled] / (1 + sigma), into solid [2 pulled - (1 - sigma) own] / (1 + sigma). Conserves
/// energy: (own - in) on the fluid side is sigma times (in - own) on the solid side.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T conjugate_gain(T pulled, T own, T r, T solid_here, T solid_beyond) {
  return r * (solid_beyond - solid_here) * (own - pulled);
}

/// The same between any two kinds of matter, by their heat capacities: r = (c_x - c_nb) / (c_x + c_nb). It is the law
/// above where one of them is fluid, c = 1, and passes what was pulled between like nodes.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T conjugate_gain_of(T pulled, T own, T capacity_here, T capacity_beyond) {
  return (capacity_here - capacity_beyond) / (capacity_here + capacity_beyond) * (own - pulled);
}

/// Conduction at one node (paper Eqs. 3, 4): turns its populations `g` into those after the step. g_q(x, t+1) is what
/// arrives, `pulled` from the neighbour that q comes from, and what the conjugate link adds, gain(q, pulled[q], own)
/// with `own` what left the node for it; the collision relaxes the odd part with s, the even part with s_plus towards
/// w_q T. With Lambda = 1/4, s_plus = 2 - s, so
///     g_q* = (s - 1) g_opposite(q) + (2 - s) w_q T,
/// s being the rate of the node's own material. The population at rest is what remains of T, which conserves it, with
/// what rounding has taken from what the links add.
template <class T, class Set, class Gain>
KOKKOS_FORCEINLINE_FUNCTION void conduct_node(T (&g)[Set::Q], const T (&pulled)[Set::Q], T s,
                                              const Rounding<T>& rounding, int node, const Gain& gain) {
  T in[Set::Q];
  T temperature = g[0], lost = 0;
  VUG_UNROLL
  for (int q = 1; q < Set::Q; ++q) {
    const T gained = gain(q, pulled[q], g[Set::opposite(q)]);
    temperature += in[q] = pulled[q] + gained;
    lost += Rounding<T>::lacking(pulled[q], gained, in[q]);
  }
  const T even = (2 - s) * temperature;
  RestPopulation<T, Set, T> rest(temperature, lost);
  VUG_UNROLL
  for (int q = 1; q < Set::Q; ++q) {
    g[q] = (s - 1) * in[Set::opposite(q)] + T(Set::w(q)) * even;
    rest.change(q, in[q], g[q], g[q]);
  }
  g[0] = rest.of_sum(g[0], rounding, node);
}

/// What the conjugate link takes for the node beyond: its mask, or, where nothing is computed (`outside_lattice`,
/// `inside_opening`), that of the node itself. D2Q5 without openings never meets such a node.
template <class T, class Set, bool Openings>
KOKKOS_FORCEINLINE_FUNCTION T solid_beyond(T beyond, T solid) {
  if constexpr (Set::Q == D2Q5::Q && !Openings)
    return beyond;
  else
    return beyond > 1 ? solid : beyond;
}

/// The matter of the nodes, for the conduction at one of them: fluid and one solid. `kind` is a byte per node. `staged`
/// converts it to the number that the law takes for the node and for those beyond its links.
template <class T, class Set, bool Openings>
struct TwoPhases {
  T fluid_rate, rate_step, reflection;
  Rounding<T> rounding;
  Kokkos::View<const std::uint8_t*> kind;

  explicit TwoPhases(const HeatFields<T>& fields)
      : fluid_rate(fields.rates.fluid),
        rate_step(fields.rates.solid - fields.rates.fluid),
        reflection(fields.rates.reflection),
        rounding(fields.rounding.at_nodes),
        kind(fields.solid) {}
  KOKKOS_FORCEINLINE_FUNCTION T staged(std::uint8_t k) const { return static_cast<T>(k); }
  KOKKOS_FORCEINLINE_FUNCTION static T beyond(T there, T here) { return solid_beyond<T, Set, Openings>(there, here); }
  KOKKOS_FORCEINLINE_FUNCTION static bool computed(T here) { return !Openings || here <= 1; }
  KOKKOS_FORCEINLINE_FUNCTION void conduct(int node, T (&g)[Set::Q], const T (&pulled)[Set::Q], std::uint8_t, T here,
                                           const T (&there)[Set::Q]) const {
    conduct_node<T, Set>(g, pulled, fluid_rate + here * rate_step, rounding, node,
                         [&](int q, T arrived, T own)
                             VUG_INLINED { return conjugate_gain(arrived, own, reflection, here, there[q]); });
  }
};

/// Fluid and minerals: the staged numbers are heat capacities.
template <class T, class Set>
struct ManyMinerals {
  Kokkos::View<const std::uint8_t*> kind;
  Kokkos::View<const double*> capacity, rate;
  Rounding<T> rounding;

  explicit ManyMinerals(const HeatFields<T>& fields)
      : kind(fields.matter.of_node),
        capacity(fields.matter.capacity),
        rate(fields.matter.rate),
        rounding(fields.rounding.at_nodes) {}
  KOKKOS_FORCEINLINE_FUNCTION T staged(std::uint8_t k) const { return static_cast<T>(capacity(k)); }
  KOKKOS_FORCEINLINE_FUNCTION static T beyond(T there, T here) { return there > 0 ? there : here; }
  KOKKOS_FORCEINLINE_FUNCTION static bool computed(T here) { return here > 0; }
  KOKKOS_FORCEINLINE_FUNCTION void conduct(int node, T (&g)[Set::Q], const T (&pulled)[Set::Q], std::uint8_t k, T here,
                                           const T (&there)[Set::Q]) const {
    conduct_node<T, Set>(g, pulled, static_cast<T>(rate(k)), rounding, node, [&](int q, T arrived, T own) VUG_INLINED {
      return conjugate_gain_of(arrived, own, here, there[q]);
    });
  }
};

/// Conduction at one node with two lattices: pulls from g, writes g_next. Dense fields; lattice units. Reads Q
/// populations and a byte, writes Q. With `Openings` the nodes inside them keep what was filled in.
template <class T, class Set, class Matter>
struct Conduct {
  Matter matter;
  int pitch, plane;
  Kokkos::View<const T*> g;
  ScalarField<T> g_next;

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int node) const {
    const std::uint8_t kind = matter.kind(node);
    const T here = matter.staged(kind);
    if (!matter.computed(here)) return keep(node);
    T own[Set::Q], pulled[Set::Q], beyond[Set::Q];
    own[0] = g(node);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const int from = node - Set::c(q, 1) * pitch - Set::c(q, 0);
      own[q] = g(q * plane + node);
      pulled[q] = g(q * plane + from);
      beyond[q] = matter.beyond(matter.staged(matter.kind(from)), here);
    }
    matter.conduct(node, own, pulled, kind, here, beyond);
    VUG_UNROLL
    for (int q = 0; q < Set::Q; ++q) g_next(q * plane + node) = own[q];
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION void keep(int node) const {
    for (int q = 0; q < Set::Q; ++q) g_next(q * plane + node) = g(q * plane + node);
  }
};

/// One node of a conduction step of these fields from `fields.g` to `g_next`.
template <class Set, class T, class Matter>
Conduct<T, Set, Matter> conduct_body(const HeatFields<T>& fields, const Matter& matter, const ScalarField<T>& g_next) {
  return {matter, fields.lattice.pitch, fields.lattice.size(), fields.g, g_next};
}

/// What the flow adds to the post-collision populations of one fluid node; the collision is linear, so this may follow
/// conduction. Carried: g_q* += s w_q T 3 c_q.u, and on D2Q9 the even part of the equilibrium with its own rate, 2 - s.
/// Towards solid and closed sides this part stays at its node, in the population at rest: only conducted heat crosses a
/// wall. The advective form (advective_form.hpp) subtracts T e' from the population at rest before the collision, e'
/// being what streaming has added to a uniform temperature: the carried part builds up over the relaxation time, so e'
/// lags behind e in the same way, e' = (1 - s) e' + s e. A uniform temperature then stays uniform to round-off in any
/// flow, steady or not. V is T or a pack of such numbers.
template <class T, class Set>
struct Convection {
  T rate;  ///< s of the fluid

  /// e' after a step with the defect e.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION V follow(const V& lagged, const V& defect) const {
    return lagged + rate * (defect - lagged);
  }
  /// What is added to the temperature, -T e' / (1 + e').
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V added(const V& temperature, const V& lagged) {
    return -temperature * lagged / (T(1) + lagged);
  }
  /// What the flow carries along direction q, over w_q. `temperature` includes what is added.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION V carried(int q, const V& temperature, const V& ux, const V& uy) const {
    const V odd = T(3) * along(q, ux, uy);
    if constexpr (Set::Q == D2Q5::Q)
      return temperature * (rate * odd);
    else
      return temperature * (rate * odd + (2 - rate) * scalar_even_part<T>(q, ux, uy));
  }
  /// What is added to population q, over w_q; `carried` is 0 towards walls.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION V change(const V& added, const V& carried) const {
    return (2 - rate) * added + carried;
  }
};

/// Convection at one fluid node; the population at rest gets what is not added to the others. Returns the energy added.
template <class T, class Set>
struct Advect {
  Convection<T, Set> law;
  Rounding<T> rounding;
  int plane;
  IndexList node;
  Kokkos::View<const std::uint16_t*> solid_links, side_links, open_links;
  Displacement<T> u;
  Kokkos::View<const T*> defect;
  ScalarField<T> lagged, g;

  /// Bit q: nothing is carried along q.
  KOKKOS_FORCEINLINE_FUNCTION unsigned walls(int i) const {
    return closed_links(solid_links(i), side_links(i), open_links(i));
  }

  KOKKOS_FUNCTION double operator()(int i) const {
    const int n = node(i);
    const T excess = law.follow(lagged(i), defect(i));
    const T conducted = sum_of_populations<Set, T>(&g(n), plane);
    const T added = law.added(conducted, excess), temperature = conducted + added;
    const unsigned walled = walls(i);
    RestPopulation<T, Set, T> rest(added, added);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const T carried = walled >> q & 1u ? T(0) : law.carried(q, temperature, u(i, 0), u(i, 1));
      const T change = T(Set::w(q)) * law.change(added, carried), before = g(q * plane + n);
      g(q * plane + n) = before + change;
      rest.change(q, before, before + change, change);
    }
    g(n) = rest.of_gain(g(n), rounding, n);
    lagged(i) = excess;
    return static_cast<double>(added);
  }
};

/// What the flow adds to the populations of one fluid node of these fields.
template <class T, class Set>
Advect<T, Set> advect_body(const FluidNodes& nodes, const Displacement<T>& u, const ScalarField<T>& defect,
                           const ScalarField<T>& lagged, const HeatFields<T>& fields) {
  return {{fields.rates.fluid},
          fields.rounding.at_links,
          fields.lattice.size(),
          nodes.node,
          nodes.solid_links,
          nodes.side_links,
          nodes.open_links,
          u,
          defect,
          lagged,
          fields.g};
}

}  // namespace vug
