#include "kernels/momentum_exchange.hpp"

#include "kernels/dense_neighbour.hpp"
#include "kernels/launch.hpp"
#include "kernels/unroll.hpp"

namespace vug {

/// Gathers 2 A c over the links of one solid node in the order of q. Reads up to eight indices and populations.
template <class T>
struct ExchangeMomentum {
  DenseNeighbour lattice;
  IndexList surface, index;
  Kokkos::View<const T*> f;
  int capacity;
  VectorField<double> force;
  KOKKOS_FUNCTION void operator()(int s) const {
    double fx = 0, fy = 0;
    VUG_UNROLL
    for (int q = 1; q < D2Q9::Q; ++q) {
      const int i = lattice.fluid_along(index, surface(s), D2Q9::opposite(q));
      if (i < 0) continue;
      const double twice = 2 * double(f(q * capacity + i));
      fx += twice * D2Q9::c(q, 0);
      fy += twice * D2Q9::c(q, 1);
    }
    force(s, 0) = fx;
    force(s, 1) = fy;
  }
};

template <class T>
void exchange_momentum(const Exec& exec, const FluidNodes& nodes, const Surface& surface, const FlowFields<T>& fields,
                       const VectorField<double>& force) {
  for_each_node(exec, "vug::momentum_exchange::gather", surface.count,
                ExchangeMomentum<T>{DenseNeighbour(nodes), surface.node, nodes.index, fields.f, nodes.capacity, force});
}

template void exchange_momentum(const Exec&, const FluidNodes&, const Surface&, const FlowFields<float>&,
                                const VectorField<double>&);
template void exchange_momentum(const Exec&, const FluidNodes&, const Surface&, const FlowFields<double>&,
                                const VectorField<double>&);

}  // namespace vug
