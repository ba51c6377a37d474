#include "kernels/flow/mean_velocity.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

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

VUG_COMPILE_FOR_NUMBERS(add_velocity)

}  // namespace vug
