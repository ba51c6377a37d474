#pragma once
// Displacement of the fluid that carries a scalar.
#include "kernels/base/base.hpp"

namespace vug {

/// How far the fluid moves in one step of a scalar that takes `steps` flow steps: steps times the velocity u (fluid,
/// axis) of the latest of them. A plain velocity converts to the displacement of one flow step.
template <class T>
struct Displacement {
  Kokkos::View<const T* [2], Kokkos::LayoutLeft> u;
  T steps = 1;

  Displacement(const VectorField<T>& velocity, int flow_steps = 1) : u(velocity), steps(static_cast<T>(flow_steps)) {}
  KOKKOS_FORCEINLINE_FUNCTION T operator()(int i, int axis) const { return steps * u(i, axis); }
};

}  // namespace vug
