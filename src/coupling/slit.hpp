#pragma once
// Conductivity of cracks: that of a slot between walls, that of a strip of whole nodes, and the drag with which the
// narrowest strip conducts like a slot narrower than a cell (docs/model.md, "Cracks narrower than a cell").
#include "base/base.hpp"

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

/// Number of rows that has this conductivity: the real root w of w^3 + w/2 = 12 K.
KOKKOS_FORCEINLINE_FUNCTION double slot_aperture(double conductivity) {
  const double root6 = 2.449489742783178;
  return 2 / root6 * Kokkos::sinh(Kokkos::asinh(36 * root6 * conductivity) / 3);
}

/// Aperture (cells) of the slot that conducts as well as the narrowest strip. The strip is the cells that a line with
/// the rise 0 <= slope <= 1 per column passes through: 1 + slope of them per column. Measured with Stokes flow, as the
/// mean of two sweeps (the flow in a row of single nodes oscillates).
KOKKOS_FORCEINLINE_FUNCTION double narrowest_aperture(double slope) {
  const double from_axis_or_diagonal = slope < 0.5 ? slope : 1 - slope;
  return 1 + 0.264 * slope + 0.18 * from_axis_or_diagonal * from_axis_or_diagonal;
}

/// Resistance 1/k (1/cells^2) to give to each node of the narrowest strip so that it conducts K (cells^3) along its
/// line; 0 where the strip conducts no better without it. The whole flow rate Q passes through each node. Where the
/// flow goes straight, its velocity is Q and the power of the drag nu Q^2/k. Where it turns into the next row, its
/// velocity is (Q/2, Q/2) and the power half of that. A column has 1 - slope nodes of the first kind and 2 slope of the
/// second, in all nu Q^2/k whatever the slope. Hence 1/K = 1/K_strip + 1/(k sqrt(1 + slope^2)). This is exact along an
/// axis and at 45 degrees. In between, fluid that cuts corners meets up to 9 % less drag, which the last factor
/// corrects (measured).
KOKKOS_FORCEINLINE_FUNCTION double slit_resistance(double conductivity, double slope) {
  const double strip = slot_conductivity(narrowest_aperture(slope));
  if (conductivity >= strip) return 0;
  return (1 / conductivity - 1 / strip) * Kokkos::sqrt(1 + slope * slope) * (1 + 0.34 * slope * (1 - slope));
}

}  // namespace vug
