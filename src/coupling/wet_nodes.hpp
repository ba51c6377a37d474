#pragma once
// The nodes of each triangle that the fluid touches: where it pushes the rock and dissolves it.
#include "coupling/rock_map.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// The surface nodes by the sector (3 * triangle + edge) in which they lie, found again when the surface changes.
class WetNodes {
 public:
  WetNodes(const Lattice& lattice, const NodeGroups& nodes_of_sector);
  void find(const Exec& exec, const Surface& surface);

  int sectors() const { return nodes_of_sector_.count(); }
  /// (entry) dense node; the extent may exceed the number of entries.
  const IndexList& node() const { return node_; }
  /// (sector + 1) where the entries of each sector begin.
  const IndexList& of_sector() const { return of_sector_; }
  /// (triangle + 1) where the entries of each triangle begin.
  const IndexList& of_triangle() const { return of_triangle_; }

 private:
  NodeGroups nodes_of_sector_;
  IndexList node_, of_sector_, of_triangle_;
  Kokkos::View<std::uint8_t*> wet_;  ///< (dense node) 1 on the surface while the nodes are being found, otherwise 0
};

}  // namespace vug
