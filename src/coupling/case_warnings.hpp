#pragma once
// What a case allows although it is probably not meant, as far as the lattice and the rock tell.
#include "coupling/build_modules.hpp"

#include <string>
#include <vector>

namespace vug {

/// One line each: of the reader, of the picture, of the triangles, and of `paths`, those of the fluid now.
std::vector<std::string> warnings_of(const Scene& scene, const Parts& parts, const FlowPaths& paths);

}  // namespace vug
