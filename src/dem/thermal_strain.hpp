#pragma once
// Thermal strain of a triangle. For a linear triangle with the strain alpha dT, minimum potential energy gives
//   u_k = alpha dT (X_k - x)
// for every elasticity matrix, uniquely up to rigid motion: the triangle grows about its centroid. A warm triangle is
// therefore the cold one with its lever arms scaled.
#include "base/base.hpp"

namespace vug {

/// Scale of all lever arms of a triangle whose mean temperature changed by `temperature_change`.
KOKKOS_FORCEINLINE_FUNCTION constexpr double thermal_scale(double expansion, double temperature_change) {
  return 1 + expansion * temperature_change;
}

}  // namespace vug
