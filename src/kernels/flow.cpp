#include "kernels/flow.hpp"

#include "kernels/launch.hpp"
#include "kernels/streaming.hpp"

#include <cassert>
#include <type_traits>

namespace vug {

/// No limit of speed: costs nothing in the kernel.
template <class T>
struct NoLimiter {
  static constexpr bool exists = false;
  KOKKOS_FORCEINLINE_FUNCTION int operator()(T (&)[9], Macroscopic<T>&) const { return 0; }
};

/// Brings a speed above the limit back to it: f_q += 3 w_q c_q . (limit/|u| - 1) u. Mass is kept, momentum is not.
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
    unroll<D2Q9::Q>([&](auto q) VUG_INLINED { f[q] += T(3 * D2Q9::w(q)) * along<q>(dx, dy); });
    return over ? 1 : 0;
  }
};

/// The sweep: populations after streaming, f_q(x, t+1) = f*_q(x - c_q, t) or bounced back, then collided.
/// Conserves sum rho' to rounding; adds the body force to the momentum. Moves per node 2 x 9 populations, 3 moments
/// and 8 indices (4 on average in place): 184 bytes in double and 100 in float in place, 200 and 116 with two lattices,
/// without the write-allocate of what it stores.
template <class T, class Slots, class Relaxation, class Force, class Limiter>
struct CollideAndStream {
  Kokkos::View<const T*> f;
  ScalarField<T> f_next, density;
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
  KOKKOS_FORCEINLINE_FUNCTION Macroscopic<T> moments(const T (&g)[9]) const {
    Macroscopic<T> m = macroscopic(g);
    if constexpr (Force::present) {
      m.ux += force.x / 2;
      m.uy += force.y / 2;
    }
    return m;
  }
  KOKKOS_FORCEINLINE_FUNCTION int collide(int i, T (&g)[9]) const {
    Macroscopic<T> m = moments(g);
    const int limited = limit(g, m);
    relax(g, m, force);
    density(i) = m.rho;
    u(i, 0) = m.ux;
    u(i, 1) = m.uy;
    return limited;
  }
  KOKKOS_FORCEINLINE_FUNCTION int operator()(int i) const {
    T g[9];
    pull(i, g);
    const int limited = collide(i, g);
    f_next(i) = g[0];
    for (int q = 1; q < D2Q9::Q; ++q) f_next(slots.leaving(q, i)) = g[q];
    return limited;
  }

  using Unlimited = CollideAndStream<T, Slots, Relaxation, Force, NoLimiter<T>>;
  KOKKOS_FORCEINLINE_FUNCTION Unlimited unlimited() const { return {f, f_next, density, u, slots, relax, force, {}}; }
};

/// A block of nodes on a host. The root and the quotient of the limiter would cost every node as much as its collision:
/// it runs where some nodes that lie together hold one that is too fast, and `limited` gains its uses.
template <class T, class Node>
struct LimitedBlock {
  Node node;
  ScalarField<double> limited;
  void operator()(int first, int last) const {
    const detail::LocalBody<Node> copy(node);
    const detail::LocalBody<typename Node::Unlimited> free(node.unlimited());
    constexpr int some = shortest_block;
    int uses = 0;
    for (int from = first; from < last; from += some) {
      const int to = from + some < last ? from + some : last;
      if (has_fast_node(copy.body, from, to)) [[unlikely]] {
        for (int i = from; i < to; ++i) uses += copy.body(i);
      } else {
        VUG_VECTORISE
        for (int i = from; i < to; ++i) free.body(i);
      }
    }
    limited(first / nodes_per_block) += uses;
  }

 private:
  static bool has_fast_node(const Node& node, int first, int last) {
    int above = 0;
    VUG_VECTORISE
    for (int i = first; i < last; ++i) {
      T g[9];
      node.pull(i, g);
      const Macroscopic<T> m = node.moments(g);
      above += node.limit.is_above(m.ux, m.uy) ? 1 : 0;
    }
    return above > 0;
  }
};

/// A block of nodes from home, by eights: the indices are 20 bytes per node instead of 32 (178 and 94 bytes per node).
/// The limiter as above; eight nodes that it is for are pulled again.
template <class T, class Node>
struct EightFromHome {
  Node node;
  Kokkos::View<const SourceWindow*> windows;
  ScalarField<double> limited;
  void operator()(int first, int last) const {
    const detail::LocalBody<Node> copy(node);
    const Node& local = copy.body;
    const detail::LocalBody<typename Node::Unlimited> free(node.unlimited());
    const EightNodes<T, D2Q9> eight{windows.data(), local.slots.source.data(), local.slots.capacity};
    T* const f = local.f_next.data();
    int uses = 0, i = first;
    for (; i + nodes_per_window <= last; i += nodes_per_window) {
      alignas(64) T g[D2Q9::Q][nodes_per_window];
      eight.pull(f, i, g);
      uses += collide(free.body, i, g);
      if constexpr (Node::limits)
        if (has_fast_node(local, i)) [[unlikely]] {
          eight.pull(f, i, g);
          uses += collide(local, i, g);
        }
      eight.push(f, i, g);
    }
    for (; i < last; ++i) uses += local(i);
    if constexpr (Node::limits) limited(first / nodes_per_block) += uses;
  }

 private:
  static bool has_fast_node(const Node& node, int first) {
    int above = 0;
    VUG_VECTORISE
    for (int i = first; i < first + nodes_per_window; ++i)
      above += node.limit.is_above(node.u(i, 0), node.u(i, 1)) ? 1 : 0;
    return above > 0;
  }
  template <class Body>
  KOKKOS_FORCEINLINE_FUNCTION static int collide(const Body& body, int first, T (&g)[D2Q9::Q][nodes_per_window]) {
    int uses = 0;
    VUG_VECTORISE
    for (int l = 0; l < nodes_per_window; ++l) {
      T own[D2Q9::Q];
      for (int q = 0; q < D2Q9::Q; ++q) own[q] = g[q][l];
      uses += body.collide(first + l, own);
      for (int q = 0; q < D2Q9::Q; ++q) g[q][l] = own[q];
    }
    return uses;
  }
};

namespace {

/// One sweep, its choices made one after the other: collision (above), force, streaming, limiter.
template <class T>
struct Sweep {
  const Exec& exec;
  const FluidNodes& nodes;
  FlowFields<T>& fields;
  const FlowStep<T>& step;

  template <class Relaxation>
  void operator()(const Relaxation& relax) const {
    const auto [fx, fy] = step.body_force;
    if (fx == T(0) && fy == T(0))
      stream(relax, NoForce<T>{});
    else
      stream(relax, BodyForce<T>{fx, fy});
  }

  template <class Relaxation, class Force>
  void stream(const Relaxation& relax, const Force& force) const {
    if (fields.f_next.extent(0) > 0) {
      limit(TwoLattices<D2Q9>{nodes.source, nodes.capacity}, fields.f_next, relax, force);
      std::swap(fields.f, fields.f_next);
    } else if (fields.turned) {
      limit(InPlaceFromTurned<D2Q9>{nodes.capacity}, fields.f, relax, force);
      fields.turned = 0;
    } else {
      limit(InPlaceFromHome<D2Q9>{nodes.source, nodes.capacity}, fields.f, relax, force);
      fields.turned = 1;
    }
  }

  template <class Slots, class Relaxation, class Force>
  void limit(const Slots& slots, const ScalarField<T>& target, const Relaxation& relax, const Force& force) const {
    const char* label = "vug::flow::collide_and_stream";
    const auto body = [&](auto limiter) {
      return CollideAndStream<T, Slots, Relaxation, Force, decltype(limiter)>{
          fields.f, target, fields.density, fields.u, slots, relax, force, limiter};
    };
    constexpr bool by_eights = has_source_windows && std::is_same_v<Slots, InPlaceFromHome<D2Q9>>;
    const auto eights = [&](const auto& node, const ScalarField<double>& uses) {
      return EightFromHome<T, std::decay_t<decltype(node)>>{node, nodes.windows, uses};
    };
    if (step.speed_limit > T(0)) {
      assert(static_cast<int>(step.limited.extent(0)) >= block_count(nodes.count));
      const auto node = body(SpeedLimiter<T>{step.speed_limit});
      if constexpr (by_eights)
        for_each_block(exec, label, nodes.count, eights(node, step.limited), nodes_per_block);
      else if constexpr (runs_on_host)
        for_each_block(exec, label, nodes.count, LimitedBlock<T, std::decay_t<decltype(node)>>{node, step.limited},
                       nodes_per_block);
      else
        add_per_block(exec, label, nodes.count, node, step.limited);
    } else {
      const auto node = body(NoLimiter<T>{});
      if constexpr (by_eights)
        for_each_block(exec, label, nodes.count, eights(node, {}), block_of_list(nodes.count));
      else
        for_each_node(exec, label, nodes.count, node);
    }
  }
};

}  // namespace

template <class T>
void collide_and_stream(const Exec& exec, const FluidNodes& nodes, FlowFields<T>& fields, const FlowStep<T>& step) {
  const Sweep<T> sweep{exec, nodes, fields, step};
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

template void collide_and_stream(const Exec&, const FluidNodes&, FlowFields<float>&, const FlowStep<float>&);
template void collide_and_stream(const Exec&, const FluidNodes&, FlowFields<double>&, const FlowStep<double>&);

}  // namespace vug
