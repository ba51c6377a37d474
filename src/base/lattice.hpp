#pragma once
// The rectangle of nodes, how dense fields over it are numbered, and steps from node to node.
#include "base/base.hpp"
#include "base/lattice_size.hpp"
#include "base/side.hpp"
#include "base/velocity_set.hpp"

#include <array>

namespace vug {

/// nx × ny nodes at cell centres, inside a ring of halo nodes, in rows padded so that every row starts aligned.
/// Node (x, y) has its centre at ((x + 1/2) dx, (y + 1/2) dx); x in [-1, nx], y in [-1, ny] with the halo.
/// Dense fields have `size()` entries and use this numbering; entries outside the halo have no meaning: packs may read
/// them and write the same values back.
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

/// Number of nodes along a side.
inline int side_length(const Lattice& lattice, Side side) {
  return is_upright(side) ? lattice.ny : lattice.nx;
}

/// Steps from node to node, also across joined (periodic) sides.
struct DenseNeighbour {
  Lattice lattice;
  bool periodic_x = false, periodic_y = false;

  DenseNeighbour() = default;
  /// `periodic`: which opposite sides are joined, {left-right, bottom-top}.
  DenseNeighbour(const Lattice& lattice_, std::array<bool, 2> periodic)
      : lattice(lattice_), periodic_x(periodic[0]), periodic_y(periodic[1]) {}

  /// The node one step along velocity q of D2Q9; -1 outside the lattice.
  KOKKOS_FORCEINLINE_FUNCTION int along(int node, int q) const { return at(node, D2Q9::c(q, 0), D2Q9::c(q, 1)); }

  /// Fluid index of the node one step along q; -1 if it is solid or outside.
  KOKKOS_FORCEINLINE_FUNCTION int fluid_along(const IndexList& index, int node, int q) const {
    if (!periodic_x && !periodic_y) return index(node + lattice.offset(q));  // -1 in the halo as well
    const int n = along(node, q);
    return n < 0 ? -1 : index(n);
  }

  /// The inner node from which an outflow through link q of a node takes values: the neighbour opposite to q or, where
  /// that is outside the lattice, the one opposite to q along one axis; -1 if there is none.
  KOKKOS_FORCEINLINE_FUNCTION int before(int node, int q) const {
    const int dx = D2Q9::c(q, 0), dy = D2Q9::c(q, 1);
    int n = at(node, -dx, -dy);
    if (n < 0 && dx != 0) n = at(node, -dx, 0);
    if (n < 0 && dy != 0) n = at(node, 0, -dy);
    return n;
  }

  /// The node (dx, dy) away; beyond a side that is not joined, the nearest node inside.
  KOKKOS_FORCEINLINE_FUNCTION int nearest(int node, int dx, int dy) const {
    const int x = lattice.x(node) + dx, y = lattice.y(node) + dy;
    return lattice.node(periodic_x ? wrapped(x, lattice.nx) : clamped(x, lattice.nx),
                        periodic_y ? wrapped(y, lattice.ny) : clamped(y, lattice.ny));
  }

 private:
  /// The node (dx, dy) away, at most one along each axis; -1 outside the lattice.
  KOKKOS_FORCEINLINE_FUNCTION int at(int node, int dx, int dy) const {
    int x = lattice.x(node) + dx, y = lattice.y(node) + dy;
    if (periodic_x) x = folded(x, lattice.nx);
    if (periodic_y) y = folded(y, lattice.ny);
    return lattice.inside(x, y) ? lattice.node(x, y) : -1;
  }
  KOKKOS_FORCEINLINE_FUNCTION static int folded(int x, int n) { return x < 0 ? x + n : x < n ? x : x - n; }
  KOKKOS_FORCEINLINE_FUNCTION static int wrapped(int x, int n) { return (x % n + n) % n; }
  KOKKOS_FORCEINLINE_FUNCTION static int clamped(int x, int n) { return x < 0 ? 0 : x < n ? x : n - 1; }
};

}  // namespace vug
