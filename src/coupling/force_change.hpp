#pragma once
// How fast the fluid's force on the triangles changes.
#include "base/base.hpp"

namespace vug {

struct ForceChange {
  double change = 0;  ///< largest |F - before|
  double force = 0;   ///< largest |F|
};

/// Largest change over all triangles. Copies F to before (triangle, axis). Waits for the device.
ForceChange largest_force_change(const Exec& exec, const VectorField<double>& force, const VectorField<double>& before);

}  // namespace vug
