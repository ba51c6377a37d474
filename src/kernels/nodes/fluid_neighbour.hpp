#pragma once
// Neighbours in the list of fluid nodes.
#include "kernels/base/velocity_set.hpp"

namespace vug {

/// The fluid node along direction q of fluid node i, as the table of sources has it; -1: there is none.
KOKKOS_FORCEINLINE_FUNCTION int fluid_neighbour(const Kokkos::View<const int*>& source, int capacity, int q, int i) {
  const int slot = D2Q9::opposite(q) * capacity, node = source(slot + i) - slot;
  return node >= 0 && node < capacity ? node : -1;
}

}  // namespace vug
