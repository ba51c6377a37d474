#include "kernels/solute_boundary.hpp"

#include "kernels/launch.hpp"

namespace vug {

struct UniformSideConcentration {
  double value;
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int) const { return value; }
};

struct SideConcentrationProfile {
  Kokkos::View<const double*> value;
  KOKKOS_FORCEINLINE_FUNCTION double operator()(int link) const { return value(link); }
};

/// h_in = -A + 2 w C_b in the slot of the outgoing population of one link. 8 + 5 + 2 s + 16 bytes per link.
template <class T, class Set, class Concentration>
struct DressConcentration {
  IndexList fluid;
  Kokkos::View<std::uint8_t*> direction;
  ScalarField<T> h;
  ScalarField<double> gain;
  int capacity;
  Concentration C_b;
  KOKKOS_FUNCTION void operator()(int link) const {
    const int q = direction(link);
    const int slot = q * capacity + fluid(link);
    const T out = h(slot);
    const T in = T(2 * Set::w(q) * C_b(link)) - out;
    h(slot) = in;
    gain(link) += double(in) - double(out);
  }
};

/// h_in = A + area flux in the slot of the outgoing population of one link.
template <class T>
struct DressFlux {
  IndexList fluid;
  Kokkos::View<std::uint8_t*> direction;
  ScalarField<double> area;
  ScalarField<T> h;
  ScalarField<double> gain;
  int capacity;
  double flux;
  KOKKOS_FUNCTION void operator()(int link) const {
    const int slot = direction(link) * capacity + fluid(link);
    const T out = h(slot);
    const T in = out + T(area(link) * flux);
    h(slot) = in;
    gain(link) += double(in) - double(out);
  }
};

/// h_in = h*_in of the same node in the slot of the outgoing population of one link. What goes inwards from there may
/// be turned (streaming.hpp).
template <class T, class Set>
struct DressOutflow {
  IndexList fluid;
  Kokkos::View<std::uint8_t*> direction;
  Kokkos::View<const int*> source;
  ScalarField<T> h;
  ScalarField<double> gain;
  int capacity, turned;
  KOKKOS_FUNCTION void operator()(int link) const {
    const int q = direction(link);
    const int slot = q * capacity + fluid(link);
    const T out = h(slot);
    const T in = h(turned ? source(slot) : Set::opposite(q) * capacity + fluid(link));
    h(slot) = in;
    gain(link) += double(in) - double(out);
  }
};

template <class Set, class T>
void dress_concentration(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, double C_b,
                         const SoluteFields<T>& s, const ScalarField<double>& gain) {
  for_each_node(exec, "vug::solute_boundary::concentration", links.count,
                DressConcentration<T, Set, UniformSideConcentration>{
                    links.fluid, links.direction, s.h, gain, nodes.capacity, {C_b}});
}

template <class Set, class T>
void dress_concentration(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                         const ScalarField<double>& C_b, const SoluteFields<T>& s, const ScalarField<double>& gain) {
  for_each_node(exec, "vug::solute_boundary::concentration_profile", links.count,
                DressConcentration<T, Set, SideConcentrationProfile>{
                    links.fluid, links.direction, s.h, gain, nodes.capacity, {C_b}});
}

template <class Set, class T>
void dress_flux(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const ScalarField<double>& area,
                double flux, const SoluteFields<T>& s, const ScalarField<double>& gain) {
  for_each_node(exec, "vug::solute_boundary::flux", links.count,
                DressFlux<T>{links.fluid, links.direction, area, s.h, gain, nodes.capacity, flux});
}

template <class Set, class T>
void dress_outflow(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links, const SoluteFields<T>& s,
                   const ScalarField<double>& gain) {
  for_each_node(exec, "vug::solute_boundary::outflow", links.count,
                DressOutflow<T, Set>{links.fluid, links.direction, nodes.source, s.h, gain, nodes.capacity, s.turned});
}

#define VUG_INSTANTIATE(T, Set)                                                                                      \
  template void dress_concentration<Set, T>(const Exec&, const FluidNodes&, const BoundaryLinks&, double,            \
                                            const SoluteFields<T>&, const ScalarField<double>&);                     \
  template void dress_concentration<Set, T>(const Exec&, const FluidNodes&, const BoundaryLinks&,                    \
                                            const ScalarField<double>&, const SoluteFields<T>&,                      \
                                            const ScalarField<double>&);                                             \
  template void dress_flux<Set, T>(const Exec&, const FluidNodes&, const BoundaryLinks&, const ScalarField<double>&, \
                                   double, const SoluteFields<T>&, const ScalarField<double>&);                      \
  template void dress_outflow<Set, T>(const Exec&, const FluidNodes&, const BoundaryLinks&, const SoluteFields<T>&,  \
                                      const ScalarField<double>&);
VUG_INSTANTIATE(float, D2Q5)
VUG_INSTANTIATE(double, D2Q5)
VUG_INSTANTIATE(float, D2Q9)
VUG_INSTANTIATE(double, D2Q9)
#undef VUG_INSTANTIATE

}  // namespace vug
