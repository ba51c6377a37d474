#pragma once
// The fluid nodes once more, in the order of the dense lattice: for what a host does to them while a row is in its
// cache.
#include "kernels/launch/eight_lanes.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// Eight neighbours of a row with fluid among them, the first at a multiple of eight.
struct WetEight {
  int node;                          ///< dense node of the first
  int fluid;                         ///< fluid index of the first that is fluid; -1: the others' do not follow upon it
  std::uint8_t wet;                  ///< bit per node: it is fluid
  std::uint8_t closed[eight_lanes];  ///< (node) bit q - 1: nothing is carried along q (closed_links)
};

/// The fluid nodes of every row, where the host has use for it by eights, else one by one. Empty on a GPU. Holds for as
/// long as the fluid nodes and what is open of them (mark_open).
struct FluidRows {
  IndexList first;                 ///< (row + 1) entries of row y are [first(y), first(y + 1))
  IndexList fluid;                 ///< (entry) fluid index
  Kokkos::View<WetEight*> eights;  ///< (entry)
};
FluidRows fluid_rows(const Exec& exec, const FluidNodes& nodes);

}  // namespace vug
