#pragma once
// The velocity that carries a scalar which steps every n lattice steps.
#include "kernels/fluid_nodes.hpp"

namespace vug {

/// u: displacement of the fluid per scalar step, n times the velocity of the latest lattice step; e: its advective
/// defect as of the last scalar step (advective_form.hpp). Written by the flow module.
template <class T>
struct Carrier {
  int interval = 1;    ///< n
  int directions = 5;  ///< of the scalar's velocity set
  T even_weight = 1;   ///< of the defect (advective_form.hpp)
  VectorField<T> u;    ///< (fluid, axis)
  ScalarField<T> e;    ///< (fluid)

  /// True in lattice step `step` (0, 1, ...) when the scalar steps with it.
  bool due(std::int64_t step) const { return (step + 1) % interval == 0; }
};

}  // namespace vug
