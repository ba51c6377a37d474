#pragma once
// The rock before it is set in motion: a plain triangulation, as a mesh file or the generator gives it.
#include <array>
#include <map>
#include <string>
#include <vector>

namespace vug {

/// Triangles that tile the rock, SI. Triangles are counter-clockwise; vertex numbers are stable names of the points
/// (strengths are drawn from them), so they are kept wherever an assembly is stored.
struct Assembly {
  std::vector<std::array<double, 2>> vertices;  ///< m
  std::vector<std::array<int, 3>> triangles;    ///< vertex numbers, counter-clockwise
  /// Edges (vertex pairs, ordered low, high) that are cracks from the start: a pre-existing fracture.
  std::vector<std::array<int, 2>> initial_cracks;
  std::vector<int> region{};  ///< (triangle) 0: the rock, n: the n-th of its other materials; empty: all of them 0
  std::map<std::string, std::vector<int>> groups{};  ///< triangles of the named surfaces of a mesh file
};

}  // namespace vug
