#include "kernels/solute/face_exchange.hpp"

#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

template <class T>
struct FaceExchange {
  Kokkos::View<const int*> source;
  int capacity;
  Kokkos::View<const T* [2], Kokkos::LayoutLeft> excess;
  T half;  ///< half the flow steps in a step of the species
  Kokkos::View<const T*> C;
  ScalarField<T> h;
  Rounding<T> rounding;

  KOKKOS_FUNCTION double operator()(int i) const {
    T sum = 0;
    VUG_UNROLL
    for (int q = 1; q < D2Q5::Q; ++q) {
      const int node = fluid_neighbour(source, capacity, q, i), next = node >= 0 ? node : i;  // exchange with itself: 0
      sum += (q < 3 ? excess(i, q - 1) : -excess(next, q - 3)) * (C(next) - C(i));
    }
    const T before = h(i);
    h(i) = rounding.sum(before, half * sum, i);
    return static_cast<double>(h(i) - before);  // the change after rounding
  }
};

template <class T>
void exchange_at_faces(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& excess, int steps,
                       const SoluteFields<T>& s, const ScalarField<double>& correction) {
  add_per_block(exec, "vug::face_exchange::exchange", nodes.share(),
                FaceExchange<T>{nodes.source, nodes.capacity, excess, T(0.5) * static_cast<T>(steps), s.C, s.h,
                                s.rounding.at_links},
                correction);
}

VUG_COMPILE_FOR_NUMBERS(exchange_at_faces)

}  // namespace vug
