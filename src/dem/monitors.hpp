#pragma once
// Occasional checks by the host: whether the motion is sane, how many bonds are left. Not for use inside a step.
#include "dem/bonds.hpp"

#include <vector>

namespace vug {

/// The first particle whose motion is not finite or faster than allowed.
struct RunawayParticle {
  int particle = -1;  ///< -1: none
  /// |v| + |spin| sqrt(inertia/mass), m/s: of its motion and of its turning at the radius of gyration; NaN where its
  /// displacement is not finite.
  double speed = 0;
};

RunawayParticle find_runaway(const Exec& exec, const Particles& particles, double largest_speed);

/// Numbers of bonds by their state.
struct BondCounts {
  int damaged = 0;  ///< 0 < d_m < 1
  int failed_in_tension = 0;
  int failed_in_shear = 0;
  int dissolved = 0;
  int cracked_at_start = 0;

  int failed() const { return failed_in_tension + failed_in_shear + dissolved; }
};

BondCounts count_bonds(const Bonds& bonds);

/// Largest thermal strain alpha |dT| of the triangles that are not gone. `expansion` (1/K) is the one to which
/// Particles::warming belongs. Waits for the device.
double largest_thermal_strain(const Exec& exec, const Particles& particles, double expansion);

/// Force that the platen of a held side puts on the rock, N per m of thickness, summed in the order of the edges'
/// particles.
Vec2 reaction_of(const std::vector<int>& held_particles, const Particles& particles);

}  // namespace vug
