#pragma once
// Triangles that lie apart.
#include "coupling/solid_spread.hpp"

namespace vug::test {

inline TriangleNeighbours no_neighbours(int triangles) {
  const TriangleNeighbours neighbours("neighbours", triangles);
  Kokkos::deep_copy(neighbours, -1);
  return neighbours;
}

}  // namespace vug::test
