// Making, growing and filling the fields of the flow, and their sums.
#include "base/pages.hpp"
#include "kernels/flow/flow.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/nodes/streaming.hpp"

namespace vug {

template <class T>
FlowFields<T> make_flow_fields(const Exec& exec, const FluidNodes& nodes) {
  const auto populations = static_cast<std::size_t>(D2Q9::Q) * nodes.capacity;
  const bool in_parts = !nodes.share().whole();
  FlowFields<T> fields;
  fields.f = zeros<ScalarField<T>>(exec, "vug::flow::f", populations, in_parts);
  fields.u = zeros<VectorField<T>>(exec, "vug::flow::u", nodes.capacity, in_parts);
  return fields;
}

template <class T>
struct StoreDensity {
  Density<T> value;
  ScalarField<T> density;
  KOKKOS_FUNCTION void operator()(int i) const { density(i) = value(i); }
};

template <class T>
ScalarField<T> densities(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields) {
  const bool in_parts = !nodes.share().whole();
  const auto density = zeros<ScalarField<T>>(exec, "vug::flow::density", nodes.capacity, in_parts);
  for_each_node(exec, "vug::flow::densities", nodes.share(), StoreDensity<T>{Density<T>(nodes, fields), density});
  return density;
}

/// A new node at rest at the mean density of its old neighbours. New nodes read old ones only, and write themselves:
/// the result does not depend on their order.
template <class T>
struct InitialiseBirths {
  Density<T> density;  ///< of populations that are at home
  ScalarField<T> f;
  VectorField<T> u;
  Kokkos::View<const int*> source;
  int first, capacity;
  KOKKOS_FUNCTION void operator()(int item) const {
    const int i = first + item;
    double sum = 0;
    int neighbours = 0;
    for (int q = 1; q < D2Q9::Q; ++q) {
      const int upstream = upstream_node(source, capacity, q, i);
      if (upstream < 0 || upstream >= first) continue;  // a wall or another new node
      sum += double(density(upstream));
      ++neighbours;
    }
    const T mean = neighbours > 0 ? T(sum / neighbours) : T(0);
    for (int q = 0; q < D2Q9::Q; ++q) f(q * capacity + i) = T(D2Q9::w(q)) * mean;
    u(i, 0) = u(i, 1) = 0;
  }
};

template <class T>
void initialise_births(const Exec& exec, const FluidNodes& nodes, int first, int last, FlowFields<T>& fields) {
  // the links to new nodes were walls until now: their populations are at home
  settle<D2Q9>(exec, nodes, first, fields.f, fields.turned);
  for_each_node(
      exec, "vug::flow::initialise_births", last - first,
      InitialiseBirths<T>{Density<T>(nodes, fields), fields.f, fields.u, nodes.source, first, nodes.capacity});
}

template <class T>
void add_mass(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields,
              const ScalarField<double>& total) {
  add_per_block(exec, "vug::flow::add_mass", nodes.count, SumOfSlots<T, D2Q9>{fields.f, nodes.capacity}, total);
}

template <class T>
struct ComponentOfVelocity {
  VectorField<T> u;
  int axis;
  KOKKOS_FUNCTION double operator()(int i) const { return double(u(i, axis)); }
};

template <class T>
void add_velocity(const Exec& exec, const FluidNodes& nodes, const VectorField<T>& u, int axis,
                  const ScalarField<double>& total) {
  add_per_block(exec, "vug::flow::add_velocity", nodes.count, ComponentOfVelocity<T>{u, axis}, total);
}

VUG_COMPILE_FOR_NUMBERS(make_flow_fields)
VUG_COMPILE_FOR_NUMBERS(densities)
VUG_COMPILE_FOR_NUMBERS(initialise_births)
VUG_COMPILE_FOR_NUMBERS(add_mass)
VUG_COMPILE_FOR_NUMBERS(add_velocity)

}  // namespace vug
