#include "kernels/advective_form.hpp"

#include "kernels/launch.hpp"
#include "kernels/scalar_equilibrium.hpp"

namespace vug {

template <class Set, class T>
struct AdvectiveDefect {
  int capacity;
  Kokkos::View<const int*> source;
  Kokkos::View<const std::uint16_t*> solid_links, side_links, open_links;
  VectorField<T> u;
  ScalarField<T> e;

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    const unsigned closed = solid_links(i) | (side_links(i) & ~open_links(i));
    const T ux = u(i, 0), uy = u(i, 1);
    T sum = T(Set::w(0)) * (scalar_equilibrium<Set, T>(0, ux, uy) - T(1));
    for (int q = 1; q < Set::Q; ++q) {
      const int opposite = Set::opposite(q);
      const bool own = ((solid_links(i) | side_links(i)) >> opposite) & 1u;
      const bool bounced = (closed >> opposite) & 1u;
      const int from = own ? i : source(q * capacity + i) - q * capacity;
      const T arriving = scalar_equilibrium<Set, T>(q, u(from, 0), u(from, 1));
      const T returning = scalar_equilibrium<Set, T>(opposite, ux, uy);
      sum += T(Set::w(q)) * ((bounced ? returning : arriving) - T(1));
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
