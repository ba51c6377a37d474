#pragma once
// The edges of an assembly: shared ones become bonds, the others are the rock's boundary.
#include "dem/assembly.hpp"

#include <array>
#include <vector>

namespace vug {

/// An edge p -> q as its left triangle sees it.
struct Edge {
  std::array<int, 2> vertex;    ///< p, q
  std::array<int, 2> triangle;  ///< on the left (the lower number of two), on the right (-1: boundary)
};

/// All edges in the order of their first appearance in the triangles. Throws InputError when an edge has three
/// triangles or two that lie on the same side.
std::vector<Edge> find_edges(const Assembly& assembly);

}  // namespace vug
