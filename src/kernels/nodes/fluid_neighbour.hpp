#pragma once
// Neighbours in the list of fluid nodes.
#include "kernels/base/velocity_set.hpp"

namespace vug {

/// The fluid node from which fluid node i pulls direction q, by the table of sources (a View or a pointer); -1 if there
/// is none.
template <class Source>
KOKKOS_FORCEINLINE_FUNCTION int upstream_node(const Source& source, int capacity, int q, int i) {
  const int slot = q * capacity, node = source[slot + i] - slot;
  return node >= 0 && node < capacity ? node : -1;
}

/// The fluid neighbour along direction q; -1 if there is none.
template <class Source>
KOKKOS_FORCEINLINE_FUNCTION int fluid_neighbour(const Source& source, int capacity, int q, int i) {
  return upstream_node(source, capacity, D2Q9::opposite(q), i);
}

}  // namespace vug
