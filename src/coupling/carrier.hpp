#pragma once
// The velocity that carries a scalar whose steps take n lattice steps.
#include "kernels/scalar/scalar_equilibrium.hpp"

#include <cstdint>

namespace vug {

/// u: velocity of the latest lattice step; e: advective defect (advective_form.hpp) of the velocity that carried the
/// scalar in its last step. Written by the flow module.
template <class T>
struct Carrier {
  int interval = 1;      ///< n
  int directions = 5;    ///< of the scalar's velocity set
  T even_weight = 1;     ///< of the defect (advective_form.hpp)
  VectorField<T> u;      ///< (fluid, axis) the flow's own field
  ScalarField<T> e;      ///< (fluid)
  bool renewed = false;  ///< the interval has changed since e was computed

  Displacement<T> displacement() const { return {u, interval}; }

  /// Whether the scalar takes a step in lattice step `step` (0, 1, ...).
  bool due(std::int64_t step) const { return (step + 1) % interval == 0; }
};

}  // namespace vug
