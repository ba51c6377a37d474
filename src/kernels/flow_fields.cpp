// Making, growing and filling the fields of the flow, and their sums.
#include "kernels/flow.hpp"
#include "kernels/launch.hpp"

namespace vug {

template <class T>
FlowFields<T> make_flow_fields(const Exec& exec, const FluidNodes& nodes) {
  const auto named = [&](const char* name) { return Kokkos::view_alloc(exec, std::string("vug::flow::") + name); };
  const auto populations = static_cast<std::size_t>(D2Q9::Q) * nodes.capacity;
  return {ScalarField<T>(named("f"), populations), ScalarField<T>(named("f_next"), populations),
          ScalarField<T>(named("density"), nodes.capacity), VectorField<T>(named("u"), nodes.capacity)};
}

template <class T>
void fit_to_capacity(const Exec& exec, const FluidNodes& nodes, int count, FlowFields<T>& fields) {
  const int old = static_cast<int>(fields.density.extent(0));
  if (old == nodes.capacity) return;
  fields.f = restride(exec, fields.f, D2Q9::Q, count, old, nodes.capacity);
  fields.f_next = ScalarField<T>();  // freed first, so that the peak is three copies of f, not four
  fields.f_next = ScalarField<T>(Kokkos::view_alloc(exec, "vug::flow::f_next"), fields.f.extent(0));
  Kokkos::resize(exec, fields.density, nodes.capacity);
  Kokkos::resize(exec, fields.u, nodes.capacity);
}

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

template <class T>
void set_equilibrium(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields) {
  for_each_node(exec, "vug::flow::set_equilibrium", nodes.count,
                SetEquilibrium<T>{fields.f, fields.density, fields.u, nodes.capacity});
}

/// rho' of node i from its populations, summed in double.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION double density_of(const Kokkos::View<const T*>& f, int capacity, int i) {
  double sum = 0;
  for (int q = 0; q < D2Q9::Q; ++q) sum += double(f(q * capacity + i));
  return sum;
}

/// A new node at rest at the mean density of its old neighbours. New nodes read old ones only, and write themselves:
/// the result does not depend on their order.
template <class T>
struct InitialiseBirths {
  ScalarField<T> f, density;
  VectorField<T> u;
  Kokkos::View<const int*> source;
  int first, capacity;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int i = first + item;
    double sum = 0;
    int neighbours = 0;
    for (int q = 1; q < D2Q9::Q; ++q) {
      const int upstream = source(q * capacity + i) - q * capacity;  // outside [0, first) at a wall and a new node
      if (upstream < 0 || upstream >= first) continue;
      sum += density_of<T>(f, capacity, upstream);
      ++neighbours;
    }
    const T mean = neighbours > 0 ? T(sum / neighbours) : T(0);
    for (int q = 0; q < D2Q9::Q; ++q) f(q * capacity + i) = T(D2Q9::w(q)) * mean;
    density(i) = mean;
    u(i, 0) = u(i, 1) = 0;
  }
};

template <class T>
void initialise_births(const Exec& exec, const FluidNodes& nodes, int first, int last, const FlowFields<T>& fields) {
  for_each_node(exec, "vug::flow::initialise_births", last - first,
                InitialiseBirths<T>{fields.f, fields.density, fields.u, nodes.source, first, nodes.capacity});
}

template <class T>
struct MassOfNode {
  Kokkos::View<const T*> f;
  int capacity;
  KOKKOS_FUNCTION double operator()(int i) const { return density_of<T>(f, capacity, i); }
};

template <class T>
void add_mass(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields,
              const ScalarField<double>& total) {
  add_per_block(exec, "vug::flow::add_mass", nodes.count, MassOfNode<T>{fields.f, nodes.capacity}, total);
}

#define VUG_INSTANTIATE(T)                                                                         \
  template FlowFields<T> make_flow_fields(const Exec&, const FluidNodes&);                         \
  template void fit_to_capacity(const Exec&, const FluidNodes&, int, FlowFields<T>&);              \
  template void set_equilibrium(const Exec&, const FluidNodes&, const FlowFields<T>&);             \
  template void initialise_births(const Exec&, const FluidNodes&, int, int, const FlowFields<T>&); \
  template void add_mass(const Exec&, const FluidNodes&, const FlowFields<T>&, const ScalarField<double>&);
VUG_INSTANTIATE(float)
VUG_INSTANTIATE(double)
#undef VUG_INSTANTIATE

}  // namespace vug
