#include "kernels/flow.hpp"

#include "kernels/launch.hpp"

#include <cassert>

namespace vug {

/// No limit of speed: costs nothing in the kernel.
template <class T>
struct NoLimiter {
  KOKKOS_FORCEINLINE_FUNCTION int operator()(T (&)[9], Macroscopic<T>&) const { return 0; }
};

/// Brings a speed above the limit back to it: f_q += 3 w_q c_q . (limit/|u| - 1) u. Mass is kept, momentum is not.
template <class T>
struct SpeedLimiter {
  T limit;
  KOKKOS_FORCEINLINE_FUNCTION int operator()(T (&f)[9], Macroscopic<T>& m) const {
    const T u2 = m.ux * m.ux + m.uy * m.uy;
    const bool over = u2 > limit * limit;
    const T excess = over ? limit / Kokkos::sqrt(u2) - T(1) : T(0);
    const T dx = excess * m.ux, dy = excess * m.uy;
    m.ux += dx;
    m.uy += dy;
    unroll<D2Q9::Q>([&](auto q) VUG_INLINED { f[q] += T(3 * D2Q9::w(q)) * along<q>(dx, dy); });
    return over ? 1 : 0;
  }
};

/// The sweep: f_q(x, t+1) pulled from its source, then collided in place of the post-collision state.
/// Conserves sum rho' to rounding; adds the body force to the momentum. Moves per node 2 x 9 populations, 8 indices
/// and 3 moments: 200 bytes in double, 116 in float, without the write-allocate of what it stores.
template <class T, class Relaxation, class Force, class Limiter>
struct CollideAndStream {
  Kokkos::View<const T*> f;
  Kokkos::View<const int*> source;
  ScalarField<T> f_next, density;
  VectorField<T> u;
  int capacity;
  Relaxation relax;
  Force force;
  Limiter limit;

  KOKKOS_FORCEINLINE_FUNCTION void pull(int i, T (&g)[9]) const {
    g[0] = f(i);
    for (int q = 1; q < D2Q9::Q; ++q) g[q] = f(source(q * capacity + i));
  }
  KOKKOS_FORCEINLINE_FUNCTION Macroscopic<T> moments(const T (&g)[9]) const {
    Macroscopic<T> m = macroscopic(g);
    if constexpr (Force::present) {
      m.ux += force.x / 2;
      m.uy += force.y / 2;
    }
    return m;
  }
  KOKKOS_FORCEINLINE_FUNCTION void store(int i, const T (&g)[9], const Macroscopic<T>& m) const {
    for (int q = 0; q < D2Q9::Q; ++q) f_next(q * capacity + i) = g[q];
    density(i) = m.rho;
    u(i, 0) = m.ux;
    u(i, 1) = m.uy;
  }
  KOKKOS_FORCEINLINE_FUNCTION int operator()(int i) const {
    T g[9];
    pull(i, g);
    Macroscopic<T> m = moments(g);
    const int limited = limit(g, m);
    relax(g, m, force);
    store(i, g, m);
    return limited;
  }
};

namespace {

template <class T, class Relaxation, class Force>
void sweep(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, const FlowStep<T>& step,
           const Relaxation& relax, const Force& force) {
  const char* label = "vug::flow::collide_and_stream";
  const auto with = [&](auto limiter) {
    return CollideAndStream<T, Relaxation, Force, decltype(limiter)>{
        fields.f, nodes.source, fields.f_next, fields.density, fields.u, nodes.capacity, relax, force, limiter};
  };
  if (step.speed_limit > T(0)) {
    assert(static_cast<int>(step.limited.extent(0)) >= block_count(nodes.count));
    add_per_block(exec, label, nodes.count, with(SpeedLimiter<T>{step.speed_limit}), step.limited);
  } else {
    for_each_node(exec, label, nodes.count, with(NoLimiter<T>{}));
  }
}

template <class T, class Relaxation>
void sweep(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, const FlowStep<T>& step,
           const Relaxation& relax) {
  const auto [fx, fy] = step.body_force;
  if (fx == T(0) && fy == T(0))
    sweep(exec, nodes, fields, step, relax, NoForce<T>{});
  else
    sweep(exec, nodes, fields, step, relax, BodyForce<T>{fx, fy});
}

}  // namespace

template <class T>
void collide_and_stream(const Exec& exec, const FluidNodes& nodes, FlowFields<T>& fields, const FlowStep<T>& step) {
  switch (step.collision) {
    case Collision::trt:
    case Collision::bgk:
      sweep(exec, nodes, fields, step, TwoRelaxationTimes<T>(step.rates));
      break;
    case Collision::lallemand_luo:
      sweep(exec, nodes, fields, step, MultipleRelaxationTimes<T>(step.rates));
      break;
    case Collision::regularised:
      sweep(exec, nodes, fields, step, Regularised<T>(step.rates));
      break;
  }
  std::swap(fields.f, fields.f_next);
}

template void collide_and_stream(const Exec&, const FluidNodes&, FlowFields<float>&, const FlowStep<float>&);
template void collide_and_stream(const Exec&, const FluidNodes&, FlowFields<double>&, const FlowStep<double>&);

}  // namespace vug
