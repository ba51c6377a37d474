#pragma once
// A small Gmsh mesh in both formats.
#include <gtest/gtest.h>

#include <string>

namespace vug::test {

// A unit square of four triangles around its centre; the edge 1-5 is a crack. Node 9 belongs to nobody, the second
// triangle is written clockwise.
inline const std::string square_22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
made by hand
$EndComments
$PhysicalNames
2
1 7 "crack"
2 8 "the rock"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
9 0.25 0.5 0
3 1 1 0
4 0 1 0
5 0.5 5e-1 0
$EndNodes
$Elements
6
1 15 2 0 1 1
2 1 2 7 1 5 1
3 2 2 8 1 1 2 5
4 2 2 8 1 2 5 3
5 2 2 8 1 3 4 5
6 2 2 8 1 4 1 5
$EndElements
)";

inline const std::string square_41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "crack"
2 8 "the rock"
$EndPhysicalNames
$Entities
1 2 1 0
1 0 0 0 0
4 0 0 0 1 1 0 1 7 2 1 -1
5 0 0 0 1 1 0 0 2 1 -1
3 0 0 0 1 1 0 1 8 2 4 5
$EndEntities
$Nodes
2 6 1 9
0 1 0 1
1
0 0 0
2 3 0 5
2
9
3
4
5
1 0 0
0.25 0.5 0
1 1 0
0 1 0
0.5 5e-1 0
$EndNodes
$Elements
3 6 1 6
1 4 1 1
2 5 1
1 5 1 1
7 1 2
2 3 2 4
3 1 2 5
4 2 5 3
5 3 4 5
6 4 1 5
$EndElements
)";

/// A text with its first `from` replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

}  // namespace vug::test
