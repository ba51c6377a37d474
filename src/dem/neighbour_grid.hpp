#pragma once
// Search for pairs that may touch: a uniform cell list, rebuilt on the device only when particles have moved.
#include "dem/contacts.hpp"

namespace vug {

/// Cells of side >= 2 reach + skin over the rock; particles beyond its edge belong to the outermost cells.
struct NeighbourGrid {
  double left = 0, bottom = 0, cell = 1;
  int nx = 1, ny = 1;
  double reach = 0;  ///< largest distance of a corner from its centroid, m
  IndexList start;   ///< (cell + 1)
  IndexList item;    ///< particles by cell

  KOKKOS_FORCEINLINE_FUNCTION int column(double x) const { return clamped((x - left) / cell, nx); }
  KOKKOS_FORCEINLINE_FUNCTION int line(double y) const { return clamped((y - bottom) / cell, ny); }
  KOKKOS_FORCEINLINE_FUNCTION static int clamped(double place, int n) {
    return static_cast<int>(Kokkos::max(0.0, Kokkos::min(place, n - 0.5)));
  }
};

NeighbourGrid make_neighbour_grid(const Particles& particles, double skin);

/// Rebuilds the candidate pairs when contacts are active and a particle has moved by more than a quarter of the skin, a
/// bond has failed, the faces of a crack have parted or dissolved, or a triangle is gone. Two launches that return at
/// once when there is nothing to do; no host copy.
void update_contacts(const Exec& exec, const NeighbourGrid& grid, const Particles& particles, const Bonds& bonds,
                     const Contacts& contacts);

}  // namespace vug
