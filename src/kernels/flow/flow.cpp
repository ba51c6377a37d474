#include "kernels/flow/flow.hpp"

#include "kernels/flow/two_relaxation_times.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/streaming.hpp"

#include <cassert>
#include <type_traits>

namespace vug {

/// No limit of speed: costs nothing in the kernel.
template <class T>
struct NoLimiter {
  static constexpr bool exists = false;
  KOKKOS_FORCEINLINE_FUNCTION int operator()(T (&)[9], Macroscopic<T>&) const { return 0; }
};

/// Reduces a speed above the limit to the limit: f_q += 3 w_q c_q . (limit/|u| - 1) u. Mass is kept, momentum is not.
template <class T>
struct SpeedLimiter {
  static constexpr bool exists = true;
  T limit;
  KOKKOS_FORCEINLINE_FUNCTION bool is_above(T ux, T uy) const { return ux * ux + uy * uy > limit * limit; }
  KOKKOS_FORCEINLINE_FUNCTION int operator()(T (&f)[9], Macroscopic<T>& m) const {
    const bool over = is_above(m.ux, m.uy);
    const T excess = over ? limit / Kokkos::sqrt(m.ux * m.ux + m.uy * m.uy) - T(1) : T(0);
    const T dx = excess * m.ux, dy = excess * m.uy;
    m.ux += dx;
    m.uy += dy;
    unroll<D2Q9::Q>([&](auto q) VUG_INLINED { f[q] += T(3 * D2Q9::w(q)) * along(q, dx, dy); });
    return over ? 1 : 0;
  }
};

/// The sweep: populations after streaming, f_q(x, t+1) = f*_q(x - c_q, t) or bounced back, then collided.
/// Conserves sum rho' to rounding; adds the body force to the momentum. Moves per node 2 x 9 populations, the velocity
/// and 8 indices in every second step: 176 bytes in double and 96 in float. It writes every slot that it reads, so
/// there is no further traffic for lines that are only stored to.
template <class T, class Slots, class Relaxation, class Force, class Limiter>
struct CollideAndStream {
  ScalarField<T> f;
  VectorField<T> u;
  Slots slots;
  Relaxation relax;
  Force force;
  Limiter limit;
  static constexpr bool limits = Limiter::exists;

  KOKKOS_FORCEINLINE_FUNCTION void pull(int i, T (&g)[9]) const {
    g[0] = f(i);
    for (int q = 1; q < D2Q9::Q; ++q) g[q] = f(slots.arriving(q, i));
  }
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION Macroscopic<V> moments(int i, const V (&g)[9]) const {
    Macroscopic<V> m = macroscopic(g);
    if constexpr (Force::present) {
      const auto& here = law_at<V>(force, i);
      m.ux += here.x / 2;
      m.uy += here.y / 2;
    }
    return m;
  }
  /// Collides one node, or a pack of consecutive nodes, and stores the velocity.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION void collide(int i, V (&g)[9], const Macroscopic<V>& m) const {
    law_at<V>(relax, i)(g, m, law_at<V>(force, i));
    put(&u(i, 0), m.ux);
    put(&u(i, 1), m.uy);
  }
  KOKKOS_FORCEINLINE_FUNCTION int collide(int i, T (&g)[9]) const {
    Macroscopic<T> m = moments(i, g);
    const int limited = limit(g, m);
    collide(i, g, m);
    return limited;
  }
  KOKKOS_FORCEINLINE_FUNCTION int operator()(int i) const {
    T g[9];
    pull(i, g);
    const int limited = collide(i, g);
    f(i) = g[0];
    for (int q = 1; q < D2Q9::Q; ++q) f(slots.leaving(q, i)) = g[q];
    return limited;
  }
};

/// Sweeps a block of nodes on a host in packs that stay in registers from pull to push. The square root and the
/// division of the limiter would cost every node as much as its collision: it runs lane by lane, and only where a node
/// of a pack is too fast. Where the runs of slots of consecutive packs overlap, the next is pulled before this one is
/// pushed: a load that overlaps a recent store would have to wait for it.
template <class T, class Node, class NodePacks>
struct SweepBlock {
  Node node;
  NodePacks packs;
  ScalarField<double> limited;  ///< (block) uses of the limiter are added to it

  void operator()(int first, int last) const {
    const Node local = node;
    const NodePacks nodes = packs;
    int uses = 0, i = first;
    Pack<T> g[D2Q9::Q], next[D2Q9::Q];
    if (NodePacks::runs_overlap && i + pack_size <= last) nodes.pull(local.f.data(), i, next);
    for (; i + pack_size <= last; i += pack_size) {
      if constexpr (NodePacks::runs_overlap) {
        VUG_UNROLL
        for (int q = 0; q < D2Q9::Q; ++q) g[q] = next[q];
      } else {
        nodes.pull(local.f.data(), i, g);
      }
      const Macroscopic<Pack<T>> m = local.moments(i, g);
      if (has_fast_node(local, m)) [[unlikely]]
        uses += one_by_one(local, i, g);
      else
        local.collide(i, g, m);
      if (NodePacks::runs_overlap && i + 2 * pack_size <= last) nodes.pull(local.f.data(), i + pack_size, next);
      nodes.push(local.f.data(), i, g);
    }
    for (; i < last; ++i) uses += local(i);
    if constexpr (Node::limits) limited(first / nodes_per_block) += uses;
  }

 private:
  static bool has_fast_node(const Node& node, const Macroscopic<Pack<T>>& m) {
    if constexpr (Node::limits)
      return PackOf<T>::any_above(m.ux * m.ux + m.uy * m.uy, Pack<T>{} + node.limit.limit * node.limit.limit);
    else
      return false;
  }
  /// Collides a pack node by node. Only the copies made here have an address, so that the populations of all other
  /// packs stay in registers.
  KOKKOS_FORCEINLINE_FUNCTION static int one_by_one(const Node& node, int first, Pack<T> (&g)[D2Q9::Q]) {
    alignas(64) T lanes[D2Q9::Q][pack_size];
    VUG_UNROLL
    for (int q = 0; q < D2Q9::Q; ++q) PackOf<T>::store(lanes[q], g[q]);
    const int uses = collide_lanes(node, first, lanes);
    VUG_UNROLL
    for (int q = 0; q < D2Q9::Q; ++q) g[q] = PackOf<T>::load(lanes[q]);
    return uses;
  }
  /// Not inlined, so that its constants do not take the registers of packs.
  [[gnu::noinline, gnu::cold]] static int collide_lanes(const Node& node, int first, T (&lanes)[D2Q9::Q][pack_size]) {
    int uses = 0;
    for (int l = 0; l < pack_size; ++l) {
      T own[D2Q9::Q];
      for (int q = 0; q < D2Q9::Q; ++q) own[q] = lanes[q][l];
      uses += node.collide(first + l, own);
      for (int q = 0; q < D2Q9::Q; ++q) lanes[q][l] = own[q];
    }
    return uses;
  }
};

namespace {

/// One sweep. The parts of its kernel are chosen one after the other: collision (by the caller), force, streaming,
/// limiter.
template <class T>
struct Sweep {
  const Exec& exec;
  const FluidNodes& nodes;
  FlowFields<T>& fields;
  const FlowStep<T>& step;

  template <class Relaxation>
  void operator()(const Relaxation& relax) const {
    const auto [fx, fy] = step.body_force;
    if (step.theta.extent(0) > 0)
      stream(relax, Buoyancy<T>{fx, fy, step.buoyancy[0], step.buoyancy[1], step.theta});
    else if (fx == T(0) && fy == T(0))
      stream(relax, NoForce<T>{});
    else
      stream(relax, BodyForce<T>{fx, fy});
  }

  template <class Relaxation, class Force>
  void stream(const Relaxation& relax, const Force& force) const {
    visit_slots<D2Q9>(nodes, fields.turned, [&](const auto& slots) { limit(slots, relax, force); });
    fields.turned = 1 - fields.turned;
  }

  template <class Slots, class Relaxation, class Force>
  void limit(const Slots& slots, const Relaxation& relax, const Force& force) const {
    const char* label = "vug::flow::collide_and_stream";
    const auto body = [&](auto limiter) {
      return CollideAndStream<T, Slots, Relaxation, Force, decltype(limiter)>{fields.f, fields.u, slots,
                                                                              relax,    force,    limiter};
    };
    const bool limits = step.speed_limit > T(0);
    assert(!limits || static_cast<int>(step.limited.extent(0)) >= block_count(nodes.count));
    const int size = limits ? nodes_per_block : block_of_list(nodes.count);
    const auto run = [&](const auto& node) {
      using Node = std::decay_t<decltype(node)>;
      if constexpr (runs_on_host) {
        const auto packs = packs_of<T>(slots, nodes);
        const SweepBlock<T, Node, std::decay_t<decltype(packs)>> block{node, packs, step.limited};
        for_each_block(exec, label, nodes.share(), block, size);
      } else if constexpr (Node::limits)
        add_per_block(exec, label, nodes.share(), node, step.limited);
      else
        for_each_node(exec, label, nodes.share(), node);
    };
    if (limits)
      run(body(SpeedLimiter<T>{step.speed_limit}));
    else
      run(body(NoLimiter<T>{}));
  }
};

}  // namespace

template <class T>
void collide_and_stream(const Exec& exec, const FluidNodes& nodes, FlowFields<T>& fields, const FlowStep<T>& step) {
  const Sweep<T> sweep{exec, nodes, fields, step};
  if (step.spread.extent(0) > 0) {
    const VaryingRelaxationTimes<T> rates{step.spread, step.collision == Collision::trt ? T(exact_wall_magic) : T(0)};
    return sweep.stream(
        rates, Buoyancy<T>{step.body_force[0], step.body_force[1], step.buoyancy[0], step.buoyancy[1], step.theta});
  }
  switch (step.collision) {
    case Collision::trt:
    case Collision::bgk:
      sweep(TwoRelaxationTimes<T>(step.rates));
      break;
    case Collision::lallemand_luo:
      sweep(MultipleRelaxationTimes<T>(step.rates));
      break;
    case Collision::regularised:
      sweep(Regularised<T>(step.rates));
      break;
  }
}

VUG_COMPILE_FOR_NUMBERS(collide_and_stream)

}  // namespace vug
