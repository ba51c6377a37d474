#pragma once
// Warnings of what is allowed in a case but probably not intended, as far as the lattice and the rock show it.
#include "coupling/build_modules.hpp"

#include <string>
#include <vector>

namespace vug {

/// Warnings, one line each, of the reader, of the intervals, of pressures in single precision, of the picture, of the
/// triangles, and of `paths`, the present flow paths.
std::vector<std::string> warnings_of(const Scene& scene, const Parts& parts, const FlowPaths& paths);

}  // namespace vug
