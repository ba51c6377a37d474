#pragma once
// The items of a list that this process computes, one by one: for reductions, whose order does not matter, and for
// loops over some of the items.
#include "kernels/launch/launch.hpp"

namespace vug {

/// Numbers the places in the blocks of this process consecutively.
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

/// Whether this process computes item i of the list.
KOKKOS_FORCEINLINE_FUNCTION bool is_own(const Share& share, int i) {
  if (share.blocks < 0) return true;  // all are
  const int block = i / nodes_per_block;
  int first = 0, last = share.blocks;
  while (first < last) {
    const int middle = (first + last) / 2;
    if (share.block[middle] < block)
      first = middle + 1;
    else
      last = middle;
  }
  return first < share.blocks && share.block[first] == block;
}

}  // namespace vug
