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
  T even_weight;

  KOKKOS_FORCEINLINE_FUNCTION T deviation(int q, T ux, T uy) const {
    const T whole = scalar_equilibrium<Set, T>(q, ux, uy) - T(1);
    if constexpr (Set::Q == D2Q5::Q) {
      return whole;
    } else {
      const T odd = T(3) * (T(Set::c(q, 0)) * ux + T(Set::c(q, 1)) * uy);
      return odd + even_weight * (whole - odd);
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    const int closed = solid_links(i) | (side_links(i) & ~open_links(i));
    const T ux = u(i, 0), uy = u(i, 1);
    T sum = T(Set::w(0)) * deviation(0, ux, uy);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const int opposite = Set::opposite(q);
      const int from = source(q * capacity + i) - q * capacity;
      const int upstream = from >= 0 && from < capacity ? from : i;  // at a wall or a side the node itself
      const T sign = (closed >> opposite) & 1 ? T(-1) : T(1);  // what bounces back comes with the velocity reversed
      sum += T(Set::w(q)) * deviation(q, sign * u(upstream, 0), sign * u(upstream, 1));
    }
    e(i) = sum;
  }
};

template <class Set, class T>
void advective_defect(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& u, const ScalarField<T>& e,
                      T even_weight) {
  for_each_node(exec, "vug::advective_form::defect", nodes.count,
                AdvectiveDefect<Set, T>{nodes.capacity, nodes.source, nodes.solid_links, nodes.side_links,
                                        nodes.open_links, u, e, even_weight});
}

#define VUG_INSTANTIATE(T, Set) \
  template void advective_defect<Set>(const Exec&, const FluidNodes&, const VectorField<T>&, const ScalarField<T>&, T);
VUG_INSTANTIATE(float, D2Q5)
VUG_INSTANTIATE(double, D2Q5)
VUG_INSTANTIATE(float, D2Q9)
VUG_INSTANTIATE(double, D2Q9)
#undef VUG_INSTANTIATE

}  // namespace vug
