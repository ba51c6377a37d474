#pragma once
// The rectangle of nodes and how dense fields over it are numbered.
#include "kernels/base/base.hpp"
#include "kernels/base/lattice_size.hpp"
#include "kernels/base/side.hpp"
#include "kernels/base/velocity_set.hpp"

namespace vug {

/// nx × ny nodes at cell centres, inside a ring of halo nodes, in rows padded so that every row starts aligned.
/// Node (x, y) has its centre at ((x + 1/2) dx, (y + 1/2) dx); x in [-1, nx], y in [-1, ny] with the halo.
/// Dense fields have `size()` entries and use this numbering; what lies outside the halo is never read.
struct Lattice {
  static constexpr int pad = row_pad;  ///< entries before x = 0 in a row

  int nx = 0;
  int ny = 0;
  int pitch = 0;  ///< distance between rows

  Lattice() = default;
  Lattice(int nx_, int ny_) : nx(nx_), ny(ny_), pitch(row_pitch(nx_)) {}

  KOKKOS_FORCEINLINE_FUNCTION int size() const { return pitch * (ny + 2); }
  KOKKOS_FORCEINLINE_FUNCTION int node(int x, int y) const { return (y + 1) * pitch + pad + x; }
  KOKKOS_FORCEINLINE_FUNCTION int x(int node) const { return node % pitch - pad; }
  KOKKOS_FORCEINLINE_FUNCTION int y(int node) const { return node / pitch - 1; }
  KOKKOS_FORCEINLINE_FUNCTION bool inside(int px, int py) const { return px >= 0 && py >= 0 && px < nx && py < ny; }
  /// Distance in memory from a node to its neighbour along velocity q.
  KOKKOS_FORCEINLINE_FUNCTION int offset(int q) const { return D2Q9::c(q, 1) * pitch + D2Q9::c(q, 0); }
};

/// Nodes along a side.
inline int side_length(const Lattice& lattice, Side side) {
  return is_upright(side) ? lattice.ny : lattice.nx;
}

/// Dense neighbour of `node` along velocity q, joined sides included; -1 outside the lattice.
KOKKOS_FORCEINLINE_FUNCTION int neighbour(const Lattice& lattice, bool periodic_x, bool periodic_y, int node, int q) {
  int x = lattice.x(node) + D2Q9::c(q, 0);
  int y = lattice.y(node) + D2Q9::c(q, 1);
  if (periodic_x) x = (x + lattice.nx) % lattice.nx;
  if (periodic_y) y = (y + lattice.ny) % lattice.ny;
  return lattice.inside(x, y) ? lattice.node(x, y) : -1;
}

}  // namespace vug
