#pragma once
// Triangles that have left the place where a lattice has them.
#include "dem/particles.hpp"

namespace vug {

/// Whether triangle t has moved by more than half its size in the preload or since: 4 |u_reference|^2 > area or
/// 4 |u - u_reference|^2 > area. The area is that of the triangle itself, because the lattice may have no solid node in
/// it.
KOKKOS_FORCEINLINE_FUNCTION bool is_out_of_place(const Particles& p, int t) {
  const double x0 = p.u_reference(t, 0), y0 = p.u_reference(t, 1), x = p.u(t, 0) - x0, y = p.u(t, 1) - y0;
  const auto side = [&](int end, int axis) { return p.corner(t, end, axis) - p.corner(t, 0, axis); };
  const double area = Kokkos::abs(side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0)) / 2;
  return 4 * (x * x + y * y) > area || 4 * (x0 * x0 + y0 * y0) > area;
}

/// Number of triangles out of their place that are not gone; where `loose` is not empty (find_loose_pieces), only of
/// those that are of no loose piece. Waits for the device.
int count_out_of_place(const Exec& exec, const Particles& particles, const IndexList& loose = {});

}  // namespace vug
