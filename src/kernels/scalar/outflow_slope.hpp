#pragma once
// Conduction that an outflow subtracts.
#include "kernels/base/base.hpp"

namespace vug {

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
