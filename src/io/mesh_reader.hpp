#pragma once
// Reads rock from a Gmsh mesh file.
#include "dem/assembly.hpp"

#include <string>

namespace vug {

/// Reads the triangles of a Gmsh .msh file, ASCII, format 2.2 or 4.1, coordinates in m. Lines of a physical group named
/// "crack" or "notch" become initial cracks. All other lines and points are ignored, and so are nodes without a
/// triangle. Vertices keep the order of the file. Throws FileError for a file that cannot be read, and InputError, with
/// file and line, for one that is not such a mesh or not usable as rock (an angle below 10 degrees, loose pieces,
/// overlaps).
Assembly read_mesh(const std::string& path);

/// As read_mesh, from text; `path` is for messages.
Assembly parse_mesh(const std::string& text, const std::string& path);

}  // namespace vug
