#pragma once
// The sweep of the lattice kinetic scheme, for a node or a pack, and how a host runs it over a block.
#include "base/unroll.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/streaming.hpp"
#include "kernels/scalar/rounding.hpp"
#include "kernels/scalar/scalar_equilibrium.hpp"
#include "kernels/solute/solute.hpp"

#include <type_traits>

namespace vug {

/// Advection policies: what the sweep reads of the flow.
struct NoAdvection {
  static constexpr bool moves = false;
  static constexpr bool advective_form = false;
};

template <class T>
struct Advection {
  static constexpr bool moves = true;
  static constexpr bool advective_form = false;
  Displacement<T> u;
};

template <class T>
struct AdvectiveForm {
  static constexpr bool moves = true;
  static constexpr bool advective_form = true;
  Displacement<T> u;
  Kokkos::View<const T*> e;
};

/// Calls visit(flow) with the advection policy of `carrier`.
template <class T, class Visit>
void visit_flow(const SoluteCarrier<T>& carrier, const Visit& visit) {
  if (!carrier.displacement)
    visit(NoAdvection{});
  else if (carrier.defect)
    visit(AdvectiveForm<T>{*carrier.displacement, *carrier.defect});
  else
    visit(Advection<T>{*carrier.displacement});
}

/// The collision of one node, or of a pack: with C = sum h, J = sum c h and heq = w C (1 + 3 c.u [+ 9/2 (c.u)^2 -
/// 3/2 u^2]):
///   h* = h - (h - heq)/tau_h + (1/tau_h - 1/tau_1) 3 w c.(J - C u),
/// which is Eqs. 14, 15 and 18 solved for the gradient, 3 (J - C u)/(tau_B - tau_h). Conserves sum h.
template <class T, class Set>
struct SoluteCollision {
  T rate_h, rate_difference;
  Rounding<T> rounding;

  explicit SoluteCollision(const SoluteParameters& p, const Rounding<T>& rounding_ = {})
      : rate_h(T(1 / p.tau_h)), rate_difference(T(1 / p.tau_h - 1 / p.tau_1)), rounding(rounding_) {}

  /// Relaxes populations g of node i, of which c is the sum together with what is `added` to them; (x, y) is J - C u.
  /// The population at rest is what remains of c: rounded weights do not add up to one, and the difference (5e-17 of C
  /// in double, 3e-8 in float) would be gained or lost at every node in every step.
  template <bool moves, class V>
  KOKKOS_FORCEINLINE_FUNCTION void relax(int i, V (&g)[Set::Q], const V& c, const V& ux, const V& uy, V x, V y,
                                         const V& added = {}) const {
    x *= rate_difference;
    y *= rate_difference;
    RestPopulation<T, Set, V> rest(c, added);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      V wc = T(Set::w(q)) * c;
      if constexpr (moves) wc *= scalar_equilibrium<Set, T>(q, ux, uy);
      const V before = g[q];
      g[q] += rate_h * (wc - g[q]) + T(3 * Set::w(q)) * along(q, x, y);
      rest.change(q, before, g[q], g[q]);
    }
    g[0] = rest.of_sum(g[0], rounding, i);
  }
};

/// Pull, collide, store, in place. With the advective form it returns what it adds to sum h, -C e with C (1 + e) = sum
/// of the pulled populations. Bytes per node, size of T = s: 2 Q s + s, in every other step 4 (Q - 1) (by windows
/// 3 (Q - 1)), + 2 s with advection, + s with the advective form.
template <class T, class Set, class Slots, class Flow>
struct SoluteSweep {
  Slots slots;
  ScalarField<T> h, C;
  SoluteCollision<T, Set> collision;
  Flow flow;

  static constexpr int Q = Set::Q;
  static constexpr bool adds = Flow::advective_form;

  KOKKOS_FORCEINLINE_FUNCTION T operator()(int i) const {
    T g[Set::Q];
    g[0] = h(i);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) g[q] = h(slots.arriving(q, i));
    const T added = finish(i, g);
    h(i) = g[0];
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) h(slots.leaving(q, i)) = g[q];
    return added;
  }

  /// Concentration and collision of the populations that have arrived, for one node or a pack of consecutive nodes;
  /// returns what is added.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION V finish(int i, V (&g)[Set::Q]) const {
    V c = g[0], flux_x{}, flux_y{}, added{};
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      c += g[q];
      if (Set::c(q, 0) != 0) flux_x += Set::c(q, 0) > 0 ? g[q] : -g[q];
      if (Set::c(q, 1) != 0) flux_y += Set::c(q, 1) > 0 ? g[q] : -g[q];
    }
    if constexpr (Flow::advective_form) {
      const V e = fetch<V>(&flow.e(i));
      const V change = -c * e / (T(1) + e);
      added = Rounding<T>::to_nearest ? g[0] + change - g[0] : change;  // what the population at rest holds of it
      c += added;
    }
    put(&C(i), c);
    collide(i, g, c, added, flux_x, flux_y);
    return added;
  }

  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION void collide(int i, V (&g)[Set::Q], const V& c, const V& added, const V& flux_x,
                                           const V& flux_y) const {
    if constexpr (Flow::moves) {
      const V ux = flow.u.steps * fetch<V>(&flow.u.u(i, 0)), uy = flow.u.steps * fetch<V>(&flow.u.u(i, 1));
      collision.template relax<true>(i, g, c, ux, uy, flux_x - c * ux, flux_y - c * uy, added);
    } else {
      collision.template relax<false>(i, g, c, V{}, V{}, flux_x, flux_y, added);
    }
  }
};

/// Sweeps a block of nodes on a host in packs that stay in registers. What they add is summed as by add_per_block.
template <class T, class Sweep, class NodePacks>
struct SweepPacks {
  Sweep sweep;
  NodePacks packs;
  ScalarField<double> correction;

  void operator()(int first, int last) const {
    const Sweep local = sweep;
    const NodePacks nodes = packs;
    constexpr int several = 4;
    alignas(64) double sum[pack_size] = {};
    int i = first;
    for (; i + several * pack_size <= last; i += several * pack_size) by_packs<several>(local, nodes, i, sum);
    for (; i + pack_size <= last; i += pack_size) by_packs<1>(local, nodes, i, sum);
    for (int l = 0; i < last; ++i, ++l) sum[l] += static_cast<double>(local(i));
    if constexpr (Sweep::adds) correction(first / nodes_per_block) += sum_of_lanes(sum);
  }

 private:
  /// All are pulled before any is pushed: a load that overlaps a recent store would have to wait for it.
  template <int count>
  KOKKOS_FORCEINLINE_FUNCTION static void by_packs(const Sweep& local, const NodePacks& nodes, int first,
                                                   double (&sum)[pack_size]) {
    Pack<T> g[count][Sweep::Q];
    T* const h = local.h.data();
    for (int k = 0; k < count; ++k) nodes.pull(h, first + k * pack_size, g[k]);
    for (int k = 0; k < count; ++k) {
      const Pack<T> added = local.finish(first + k * pack_size, g[k]);
      if constexpr (Sweep::adds) PackOf<T>::add_to(sum, added);
    }
    for (int k = 0; k < count; ++k) nodes.push(h, first + k * pack_size, g[k]);
  }
};

/// The sweep of a species.
template <class Set, class T, class Slots, class Flow>
SoluteSweep<T, Set, Slots, Flow> solute_sweep(const Slots& slots, const SoluteParameters& p, const SoluteFields<T>& s,
                                              Flow flow) {
  if constexpr (Flow::moves) flow.u.steps *= static_cast<T>(p.carried);
  return {slots, s.h, s.C, SoluteCollision<T, Set>(p, s.rounding.at_nodes), flow};
}

/// The body(first, last) with which a host sweeps a block of sweep_block_size nodes.
template <class T, class Set, class Slots, class Flow>
auto sweep_of_block(const FluidNodes& nodes, const SoluteSweep<T, Set, Slots, Flow>& sweep,
                    const ScalarField<double>& correction) {
  const auto packs = packs_of<T>(sweep.slots, nodes);
  return SweepPacks<T, SoluteSweep<T, Set, Slots, Flow>, std::decay_t<decltype(packs)>>{sweep, packs, correction};
}

/// Number of nodes of such a block; where sums are taken, that of add_per_block.
template <class Flow>
int sweep_block_size(int count) {
  return Flow::advective_form ? nodes_per_block : block_of_list(count);
}

}  // namespace vug
