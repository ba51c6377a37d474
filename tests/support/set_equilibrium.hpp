#pragma once
// A flow that begins in motion, for tests and timings: a run begins at rest.
#include "kernels/flow/flow.hpp"
#include "kernels/launch/launch.hpp"

namespace vug::test {

/// f_q = feq_q(rho', u).
template <class T>
struct SetEquilibrium {
  ScalarField<T> f;
  Kokkos::View<const T*> density;
  Kokkos::View<const T* [2], Kokkos::LayoutLeft> u;
  int capacity;
  KOKKOS_FUNCTION void operator()(int i) const {
    for (int q = 0; q < D2Q9::Q; ++q) f(q * capacity + i) = equilibrium(q, density(i), u(i, 0), u(i, 1));
  }
};

/// f = feq(density, u) on every node, from a density (fluid) and the velocity that the fields hold.
template <class T>
void set_equilibrium(const Exec& exec, const FluidNodes& nodes, const ScalarField<T>& density, FlowFields<T>& fields) {
  fields.turned = 0;
  for_each_node(exec, "vug::flow::set_equilibrium", nodes.count,
                SetEquilibrium<T>{fields.f, density, fields.u, nodes.capacity});
}

}  // namespace vug::test
