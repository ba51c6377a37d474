#pragma once
// The fluid nodes in the order of the dense lattice, for work that is done row by row.
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/packs/pack.hpp"

namespace vug {

/// Eight consecutive nodes of a row, at least one of them fluid. The first is at a multiple of eight.
struct WetPack {
  int node;                ///< dense node of the first
  int fluid;               ///< fluid index of the first fluid node; -1: the others do not follow consecutively
  std::uint8_t wet;        ///< bit per node: it is fluid
  std::uint8_t closed[8];  ///< (direction - 1) bit per node: nothing is advected along it (closed_links)
};

/// The fluid nodes of every row: by packs on a host, one by one on a GPU. Valid until fluid nodes or open links
/// (mark_open) change.
struct FluidRows {
  IndexList first;               ///< (row + 1) entries of row y are [first(y), first(y + 1))
  Kokkos::View<WetPack*> packs;  ///< (entry) on a host
  IndexList fluid;               ///< (entry) on a GPU: fluid index
};
FluidRows fluid_rows(const Exec& exec, const FluidNodes& nodes);

}  // namespace vug
