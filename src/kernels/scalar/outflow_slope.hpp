#pragma once
// How much conduction an outflow takes back.
#include "kernels/base/base.hpp"

namespace vug {

/// What the rise of a scalar from the node before is multiplied by in the inward population of a side that it leaves
/// without gradient: tau - 1, twice what that population has too little at the node (docs/model.md). The rise is that
/// of before the step, and waves grow where the factor is larger than 3.8 at tau = 5, 2.5 at tau = 30 or 2.2 at any
/// (eigenvalues of a slab on D2Q5). So beyond tau = 3.5, of which vug check warns, it is 2, and the side conducts as 2
/// (tau - 3) more nodes would.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION T outflow_slope(T tau) {
  constexpr T exact_to = T(3.5), beyond = 2;
  return tau <= exact_to ? tau - 1 : beyond;
}

}  // namespace vug
