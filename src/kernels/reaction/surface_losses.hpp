#pragma once
// How much rock the nodes of a surface lose from one booking to the next.
#include "kernels/base/base.hpp"

namespace vug {

/// Losses of surface nodes, pixels. `largest` may be empty: then nothing is kept.
struct SurfaceLosses {
  ScalarField<double> recent;   ///< (surface) in this booking, by the reactants booked so far
  ScalarField<double> largest;  ///< (surface) the largest of all bookings

  /// `first`: no other reactant has been booked before in this booking.
  KOKKOS_FORCEINLINE_FUNCTION void note(int s, double loss, bool first) const {
    if (largest.extent(0) == 0) return;
    const double all = first ? loss : recent(s) + loss;
    recent(s) = all;
    if (all > largest(s)) largest(s) = all;
  }
};

}  // namespace vug
