#pragma once
// Layout of nodes in memory and their largest number. Includes nothing of Kokkos, so that a host compiler can use it.
#include <algorithm>
#include <cstdint>

namespace vug {

inline constexpr int row_pad = 16;  ///< entries before x = 0 in a row: one cache line of float, two of double

/// Entries of a row of `nx` nodes with its halo; every row starts aligned.
constexpr int row_pitch(int nx) {
  return (row_pad + nx + 1 + row_pad - 1) / row_pad * row_pad;
}

/// Dense nodes of a lattice of nx × ny, with its halo and the padding of its rows.
constexpr std::int64_t dense_nodes(int nx, int ny) {
  return std::int64_t{row_pitch(nx)} * (std::int64_t{ny} + 2);
}

/// Largest number of nodes of a lattice of nine directions: the number of a slot, direction times nodes plus node, is
/// an int.
inline constexpr std::int64_t most_nodes = 2147483647 / 9;

/// Capacity for a list that has grown to `count` of nx × ny nodes: half as many more, so that growth is rare, but no
/// more than the lattice has.
constexpr int grown_capacity(int nx, int ny, int count) {
  const std::int64_t roomy = std::int64_t{count} + count / 2, all = std::int64_t{nx} * ny;
  return static_cast<int>(std::min(roomy, all));
}

}  // namespace vug
