#pragma once
// The fluid nodes once more, in the order of the dense lattice: for what is done to them row by row.
#include "kernels/nodes/fluid_nodes.hpp"
#include "kernels/packs/pack.hpp"

namespace vug {

/// Eight neighbours of a row with fluid among them, the first at a multiple of eight.
struct WetPack {
  int node;                ///< dense node of the first
  int fluid;               ///< fluid index of the first that is fluid; -1: the others' do not follow upon it
  std::uint8_t wet;        ///< bit per node: it is fluid
  std::uint8_t closed[8];  ///< (direction - 1) bit per node: nothing is carried along it (closed_links)
};

/// The fluid nodes of every row: a host has them by packs, a GPU one by one. Holds for as long as the fluid nodes and
/// what is open of them (mark_open).
struct FluidRows {
  IndexList first;               ///< (row + 1) entries of row y are [first(y), first(y + 1))
  Kokkos::View<WetPack*> packs;  ///< (entry) on a host
  IndexList fluid;               ///< (entry) on a GPU: fluid index
};
FluidRows fluid_rows(const Exec& exec, const FluidNodes& nodes);

}  // namespace vug
