#pragma once
// The sections of a Gmsh file, in format 2.2 or 4.1.
#include "io/detail/mesh_text.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

namespace vug::detail {

/// Contents of the file's sections, from which the assembly is made.
struct RawMesh {
  std::unordered_map<std::int64_t, int> number;  // node tag -> position in `nodes`
  std::vector<std::array<double, 3>> nodes;
  std::vector<std::array<int, 3>> triangles;
  std::map<std::array<int, 3>, int> triangle_of;  // by its nodes in order of their numbers
  std::vector<std::array<int, 2>> cracks;
  std::map<std::int64_t, std::string> crack_groups;                      // names by physical tags of lines
  std::set<std::int64_t> found_groups;                                   // those of crack_groups that have a line
  std::map<std::int64_t, std::string> surface_groups;                    // names by physical tags of surfaces
  std::map<std::int64_t, std::set<std::int64_t>> crack_groups_of_curve;  // format 4: of geometric tags of lines
  std::map<std::int64_t, std::set<std::string>> groups_of_surface;       // format 4: names by geometric tags
  std::map<std::string, std::vector<int>> groups;                        // triangles of named surfaces
};

/// Reads all sections. Throws InputError with the line of what is wrong.
RawMesh read_sections(MeshText& text);

}  // namespace vug::detail
