#pragma once
// A case with some keys changed.
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

/// Returns the scene of the same case file with its own overrides and those in `more`, "table.key=value". Throws as
/// read_scene does.
Scene override_scene(const Scene& scene, const std::vector<std::string>& more);

}  // namespace vug
