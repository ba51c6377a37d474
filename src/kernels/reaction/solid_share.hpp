#pragma once
// The share of a node's solid that is left, whatever the volume that it was given.
#include "base/base.hpp"

namespace vug {

/// A node with more solid than this was given more than its own cell; rounding adds far less than this to one.
inline constexpr double own_cell = 1 + 1e-9;

/// Cells' worth of solid that a node was given: what is left and what has dissolved of it, at least its own cell.
KOKKOS_FORCEINLINE_FUNCTION double solid_given(double V, double dissolved) {
  const double given = V + dissolved;
  return given > own_cell ? given : 1.0;
}

/// Share of a node's own solid that is left: 1 in rock of which nothing has dissolved, also where V is more than a cell
/// because an opened pathway has handed on its solid; 0 in fluid.
KOKKOS_FORCEINLINE_FUNCTION double solid_share(double V, double dissolved) {
  return V / solid_given(V, dissolved);
}

/// Share of a node's own solid that has dissolved, 0 to 1.
KOKKOS_FORCEINLINE_FUNCTION double dissolved_share(double V, double dissolved) {
  const double share = dissolved / solid_given(V, dissolved);
  return share < 1 ? share : 1.0;
}

}  // namespace vug
