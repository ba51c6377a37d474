#pragma once
// The items of a list that this process computes, one by one: for reductions, whose order does not matter.
#include "kernels/launch/launch.hpp"

namespace vug {

/// Numbers the places of our blocks one after the other.
struct OwnItems {
  Share list;

  int places() const { return list.whole() ? list.n : list.blocks * nodes_per_block; }
  /// The item at a place; -1 behind the end of the list.
  KOKKOS_FORCEINLINE_FUNCTION int operator()(int place) const {
    if (list.blocks < 0) return place;
    const int item = list.block[place / nodes_per_block] * nodes_per_block + place % nodes_per_block;
    return item < list.n ? item : -1;
  }
};

}  // namespace vug
