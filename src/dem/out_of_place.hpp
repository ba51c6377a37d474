#pragma once
// Triangles that have left the place where a lattice has them, and those that nothing holds there.
#include "dem/bonds.hpp"

namespace vug {

/// Whether triangle t has moved by more than half its size since the preload: 4 |u - u_reference|^2 > area. The area is
/// that of the triangle itself, because the lattice may have no solid node in it.
KOKKOS_FORCEINLINE_FUNCTION bool is_out_of_place(const Particles& p, int t) {
  const double x = p.u(t, 0) - p.u_reference(t, 0), y = p.u(t, 1) - p.u_reference(t, 1);
  const auto side = [&](int end, int axis) { return p.corner(t, end, axis) - p.corner(t, 0, axis); };
  const double area = Kokkos::abs(side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0)) / 2;
  return 4 * (x * x + y * y) > area;
}

/// Whether no bond holds triangle t any more, and no support does.
KOKKOS_FORCEINLINE_FUNCTION bool nothing_holds(const Particles& p, const Bonds& bonds, int t) {
  if (p.held(t) != 0) return false;
  for (int e = bonds.row(t); e < bonds.row(t + 1); ++e)
    if (!has_failed(bonds.state(bonds.entry(e) / 2))) return false;
  return true;
}

/// Number of triangles out of their place that are not gone; with `but_fragments` only of those that something holds,
/// as the others are let go. Waits for the device.
int count_out_of_place(const Exec& exec, const Particles& particles, const Bonds& bonds, bool but_fragments);

}  // namespace vug
