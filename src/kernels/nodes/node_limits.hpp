#pragma once
// How many nodes there can be. The number of a slot, direction times nodes plus node, is an int.
#include "kernels/base/lattice.hpp"

#include <algorithm>
#include <cstdint>

namespace vug {

/// Slots of nine directions over a lattice, with its halo and the padding of its rows; no list of its fluid nodes has
/// more.
inline std::int64_t slots_of(const Lattice& lattice) {
  return std::int64_t{D2Q9::Q} * lattice.pitch * (std::int64_t{lattice.ny} + 2);
}
inline constexpr std::int64_t most_slots = 2147483647;  ///< 2^31 - 1

/// Room for a list that has grown to `count` nodes: half as many again, so that growth is rare, but no more than the
/// lattice has.
inline int grown_capacity(const Lattice& lattice, int count) {
  const std::int64_t roomy = std::int64_t{count} + count / 2, all = std::int64_t{lattice.nx} * lattice.ny;
  return static_cast<int>(std::min(roomy, all));
}

}  // namespace vug
