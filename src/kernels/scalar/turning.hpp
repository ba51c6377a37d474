#pragma once
// The collision between two steps of a scalar that take different numbers of lattice steps.
#include "base/base.hpp"

#include <cmath>

namespace vug {

/// Relaxes the flux J that has arrived to J* = J + rate (carried C U - J), U being the displacement of the fluid in the
/// step that follows.
struct Turning {
  double rate = 1;
  double carried = 1;
};

/// The collision of a scalar with relaxation time tau after which a step takes `stretch` times as many lattice steps.
/// In a smooth field J = C U / stretch - tau grad C / 3 has arrived (D2Q5). What leaves is to be what the longer steps
/// would have left, J* = C U - (tau' - 1) grad C / 3 with tau' - 1/2 = stretch (tau - 1/2). The flux then continues
/// unchanged, and the gradient need not be known. The even moments arrive as (a/2 + 1/4) X, with a = tau - 1/2 and some
/// second derivatives X, and are to leave as (1/4 - a'/2) X with Lambda = 1/4: their rate is 2 - rate, as in an
/// ordinary collision. At stretch = 1 it is an ordinary collision, with the rate 1 / tau and carried = 1.
inline Turning turning(double tau, double stretch) {
  if (stretch == 1) return {1 / tau, 1};
  const double next_tau = 0.5 + stretch * (tau - 0.5);
  double kept = (next_tau - 1) / tau;              // 1 - rate
  if (std::abs(1 - kept) < 1e-3) kept = 1 - 1e-3;  // avoids division by zero; the flux is off by as much, once
  return {1 - kept, (1 - kept / stretch) / (1 - kept)};
}

/// Factor of the rise of a scalar from the node before, in the inward population of a side that it leaves without
/// gradient: tau - 1, twice what that population lacks at the node (docs/model.md). The rise is that before the step,
/// so waves grow where the factor is larger than 3.8 at tau = 5, 2.5 at tau = 30 or 2.2 at any tau (eigenvalues of a
/// slab on D2Q5). Beyond tau = 3.5, of which vug check warns, it is therefore 2, and the side conducts like 2 (tau - 3)
/// more nodes.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T outflow_slope(T tau) {
  constexpr T exact_to = T(3.5), beyond = 2;
  return tau <= exact_to ? tau - 1 : beyond;
}

}  // namespace vug
