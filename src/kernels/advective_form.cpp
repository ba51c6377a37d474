#include "kernels/advective_form.hpp"

#include "kernels/launch.hpp"
#include "kernels/scalar_equilibrium.hpp"
#include "kernels/unroll.hpp"

namespace vug {

template <class Set, class T>
struct AdvectiveDefect {
  int capacity;
  Kokkos::View<const int*> source;
  Kokkos::View<const std::uint16_t*> solid_links, side_links, open_links;
  VectorField<T> u;
  ScalarField<T> e;

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    const int closed = solid_links(i) | (side_links(i) & ~open_links(i));
    const T ux = u(i, 0), uy = u(i, 1);
    T sum = T(Set::w(0)) * (scalar_equilibrium<Set, T>(0, ux, uy) - T(1));
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const int opposite = Set::opposite(q);
      const int from = source(q * capacity + i) - q * capacity;
      const int upstream = from >= 0 && from < capacity ? from : i;  // at a wall or a side the node itself
      const T sign = (closed >> opposite) & 1 ? T(-1) : T(1);  // what bounces back comes with the velocity reversed
      sum += T(Set::w(q)) * (scalar_equilibrium<Set, T>(q, sign * u(upstream, 0), sign * u(upstream, 1)) - T(1));
    }
    e(i) = sum;
  }
};

template <class Set, class T>
void advective_defect(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& u, const ScalarField<T>& e) {
  for_each_node(exec, "vug::advective_form::defect", nodes.count,
                AdvectiveDefect<Set, T>{nodes.capacity, nodes.source, nodes.solid_links, nodes.side_links,
                                        nodes.open_links, u, e});
}

template void advective_defect<D2Q5>(const Exec&, const FluidNodes&, const VectorField<float>&,
                                     const ScalarField<float>&);
template void advective_defect<D2Q5>(const Exec&, const FluidNodes&, const VectorField<double>&,
                                     const ScalarField<double>&);
template void advective_defect<D2Q9>(const Exec&, const FluidNodes&, const VectorField<float>&,
                                     const ScalarField<float>&);
template void advective_defect<D2Q9>(const Exec&, const FluidNodes&, const VectorField<double>&,
                                     const ScalarField<double>&);

}  // namespace vug
