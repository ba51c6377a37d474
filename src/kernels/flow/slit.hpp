#pragma once
// What cracks conduct: between the walls of a slot, through a strip of whole nodes, and how much drag makes the
// narrowest strip conduct like a slot narrower than a cell (docs/model.md, "Cracks narrower than a cell").
#include "kernels/base/base.hpp"

namespace vug {

/// Conductivity of a plane slot of `aperture` cells, cells^3: flow rate times viscosity over the pressure gradient, the
/// cubic law (Witherspoon et al. 1980).
KOKKOS_FORCEINLINE_FUNCTION double cubic_law(double aperture) {
  return aperture * aperture * aperture / 12;
}

/// Conductivity of `aperture` rows of nodes between walls half way, cells^3: (w^3 + w/2)/12, the cubic law and the
/// midpoint rule's 1/(2 n^2).
KOKKOS_FORCEINLINE_FUNCTION double slot_conductivity(double aperture) {
  return aperture * (aperture * aperture + 0.5) / 12;
}

/// The number of rows that conducts so well: the real root w of w^3 + w/2 = 12 K.
KOKKOS_FORCEINLINE_FUNCTION double slot_aperture(double conductivity) {
  const double root6 = 2.449489742783178;
  return 2 / root6 * Kokkos::sinh(Kokkos::asinh(36 * root6 * conductivity) / 3);
}

/// Aperture (cells) of the slot that conducts as well as the narrowest strip, the cells that a line passes through
/// which rises by 0 <= slope <= 1 per column: 1 + slope of them per column. Measured with Stokes flow, as the mean of
/// two sweeps (a row of single nodes swings to and fro).
KOKKOS_FORCEINLINE_FUNCTION double narrowest_aperture(double slope) {
  const double from_axis_or_diagonal = slope < 0.5 ? slope : 1 - slope;
  return 1 + 0.264 * slope + 0.18 * from_axis_or_diagonal * from_axis_or_diagonal;
}

/// Resistance 1/k (1/cells^2) to give to each node of the narrowest strip so that it conducts K (cells^3) along its
/// line; 0 when it conducts no better without. All of the flow rate Q passes through each node. Where it goes straight
/// on its velocity is Q and the drag's power nu Q^2/k, where it turns into the next row (Q/2, Q/2) and half of that:
/// per column 1 - slope and 2 slope nodes, in all nu Q^2/k whatever the slope. So 1/K = 1/K_strip + 1/(k sqrt(1 +
/// slope^2)). Exact along an axis and at 45 degrees; between, fluid that cuts corners finds up to 9 % less: the last
/// factor, measured.
KOKKOS_FORCEINLINE_FUNCTION double slit_resistance(double conductivity, double slope) {
  const double strip = slot_conductivity(narrowest_aperture(slope));
  if (conductivity >= strip) return 0;
  return (1 / conductivity - 1 / strip) * Kokkos::sqrt(1 + slope * slope) * (1 + 0.34 * slope * (1 - slope));
}

}  // namespace vug
