#pragma once
// All that acts on the mass of the fluid: body force and buoyancy.
#include "coupling/driving_pressure.hpp"
#include "io/scene.hpp"

#include <algorithm>
#include <array>

namespace vug {

/// Accelerations that all body forces together give to fluid, per axis, lattice units.
struct BodyForces {
  std::array<Span, 2> range{};           ///< at any temperature of the case
  std::array<double, 2> at_start{0, 0};  ///< at the temperature of the start, which is the same everywhere

  /// The largest size along an axis.
  double largest(int axis) const { return std::max(-range[axis].low, range[axis].high); }
  bool act() const { return largest(0) > 0 || largest(1) > 0; }
};

/// f - g beta (T - T_0) of flow.body_force f and flow.gravity g (Boussinesq; Gray and Giorgini, Int. J. Heat Mass
/// Transfer 19 (1976) 545). Fluid of one temperature T other than T_0 is driven by it as by a body force. `scene` has
/// [flow].
BodyForces body_forces(const Scene& scene, const LatticeUnits& units);

}  // namespace vug
