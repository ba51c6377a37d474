#pragma once
// Effect of dissolution on triangles and bonds: pure functions of the share of the solid that remains.
#include "base/base.hpp"

namespace vug {

/// A triangle with less than this share of its solid is gone: it pushes nothing, weighs nothing and does not move.
inline constexpr double smallest_solid_fraction = 0.05;

/// Smallest fraction of its mass that a dissolving particle keeps, so that the time step stays finite. Its contacts
/// keep their stiffness, so a tenth would halve the step of all others because of a remnant that carries nothing.
inline constexpr double smallest_mass_fraction = 0.2;

/// Whether a particle of which `solid_fraction` remains is gone.
KOKKOS_FORCEINLINE_FUNCTION constexpr bool is_gone(double solid_fraction) {
  return solid_fraction < smallest_solid_fraction;
}

/// 0 for a particle that is gone, 1 for any other: a factor, so that loops vectorise.
KOKKOS_FORCEINLINE_FUNCTION constexpr double presence(double solid_fraction) {
  return is_gone(solid_fraction) ? 0.0 : 1.0;
}

/// Share of its solid that a group of nodes has left. `left` was the share when its nodes held the volume `held`; since
/// then it has lost `lost` of that. Sums over nodes in another order may differ by rounding, so `lost` may be slightly
/// negative: no share grows.
KOKKOS_FORCEINLINE_FUNCTION constexpr double remaining_share(double left, double lost, double held) {
  const double part = held > 0 ? lost / held : 0.0;
  return part >= 1 ? 0.0 : part > 0 ? left * (1 - part) : left;
}

/// Mass or inertia of a particle of which `solid_fraction` remains, relative to the intact one.
KOKKOS_FORCEINLINE_FUNCTION constexpr double mass_fraction(double solid_fraction) {
  return solid_fraction > smallest_mass_fraction ? solid_fraction : smallest_mass_fraction;
}

/// Linear size of the outline of a particle of which `solid_fraction` remains, relative to the intact one: its area is
/// in proportion to the solid.
KOKKOS_FORCEINLINE_FUNCTION double outline_scale(double solid_fraction) {
  return Kokkos::sqrt(solid_fraction > 0 ? solid_fraction : 0.0);
}

/// Share of one side of a bond that still carries: what is left of its sector (a third of the triangle), but no more
/// than three times what the triangle has left before it is gone, so that nothing is carried at that moment.
KOKKOS_FORCEINLINE_FUNCTION constexpr double side_left(double sector_fraction, double solid_fraction) {
  const double most = is_gone(solid_fraction) ? 0.0 : 3 * (solid_fraction - smallest_solid_fraction);
  return sector_fraction < most ? sector_fraction : most;
}

/// Chemical damage of a bond whose sides had the solid volumes V_a and V_b and have the shares s_a and s_b left. The
/// two are springs in series,
///   1 - d_c = (V_a + V_b) / (V_a / s_a + V_b / s_b),
/// which is the paper's Eq. 25 where both have lost the same share, and to first order in the loss. It is 1 as soon as
/// one side is gone.
KOKKOS_FORCEINLINE_FUNCTION constexpr double chemical_damage_of_sides(double volume_a, double left_a, double volume_b,
                                                                      double left_b) {
  if (!(left_a > 0 && left_b > 0)) return 1;
  const double volume = volume_a + volume_b;
  const double left = volume > 0 ? volume * left_a * left_b / (volume_a * left_b + volume_b * left_a) : 1.0;
  return left < 1 ? 1 - left : 0.0;
}

}  // namespace vug
