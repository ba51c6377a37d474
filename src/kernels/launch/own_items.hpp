#pragma once
// Lists are computed in blocks, which processes may share: the items of a list that this process computes.
#include "base/base.hpp"

namespace vug {

inline constexpr int nodes_per_block = 512;

KOKKOS_FORCEINLINE_FUNCTION constexpr int block_count(int n) {
  return (n + nodes_per_block - 1) / nodes_per_block;
}

/// The part of a list of n items that this process computes: all of it, or whole blocks of nodes_per_block. Every item
/// keeps its place in the list and in its block, and therefore its result to the bit, however many processes share the
/// list.
struct Share {
  int n = 0;
  int blocks = -1;             ///< number of blocks of this process; -1: all
  const int* block = nullptr;  ///< (own) their numbers, ascending

  Share(int items) : n(items) {}
  Share(int items, int count, const int* numbers) : n(items), blocks(count), block(numbers) {}
  bool whole() const { return blocks < 0; }
};

/// Numbers the places in the blocks of this process consecutively: for reductions, whose order does not matter, and for
/// loops over single items.
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
