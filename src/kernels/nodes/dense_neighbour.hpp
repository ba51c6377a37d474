#pragma once
// Nodes of the dense lattice by number, and their neighbours across joined sides.
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// Steps on the dense lattice with joined sides folded back.
struct DenseNeighbour {
  Lattice lattice;
  bool periodic_x = false, periodic_y = false;

  DenseNeighbour() = default;
  explicit DenseNeighbour(const FluidNodes& nodes)
      : lattice(nodes.lattice), periodic_x(nodes.periodic[0]), periodic_y(nodes.periodic[1]) {}

  /// The node one step along velocity q of D2Q9; -1 outside the lattice.
  KOKKOS_FORCEINLINE_FUNCTION int along(int node, int q) const {
    const int x = folded(lattice.x(node) + D2Q9::c(q, 0), lattice.nx, periodic_x);
    const int y = folded(lattice.y(node) + D2Q9::c(q, 1), lattice.ny, periodic_y);
    return lattice.inside(x, y) ? lattice.node(x, y) : -1;
  }

  /// Fluid index of the node one step along q; -1 if it is solid or outside.
  KOKKOS_FORCEINLINE_FUNCTION int fluid_along(const IndexList& index, int node, int q) const {
    if (!periodic_x && !periodic_y) return index(node + lattice.offset(q));  // -1 in the halo as well
    const int n = along(node, q);
    return n < 0 ? -1 : index(n);
  }

  /// The node (dx, dy) away; beyond a side that is not joined, the nearest node inside.
  KOKKOS_FORCEINLINE_FUNCTION int nearest(int node, int dx, int dy) const {
    const int x = clamped(folded(lattice.x(node) + dx, lattice.nx, periodic_x), lattice.nx);
    const int y = clamped(folded(lattice.y(node) + dy, lattice.ny, periodic_y), lattice.ny);
    return lattice.node(x, y);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION static int folded(int x, int n, bool periodic) { return periodic ? (x % n + n) % n : x; }
  KOKKOS_FORCEINLINE_FUNCTION static int clamped(int x, int n) { return x < 0 ? 0 : x < n ? x : n - 1; }
};

}  // namespace vug
