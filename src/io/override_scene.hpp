#pragma once
// A case once more, with some keys otherwise.
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

/// The scene that its case file gives with its own overrides and `more` of them, "table.key=value". Throws as
/// read_scene.
Scene override_scene(const Scene& scene, const std::vector<std::string>& more);

}  // namespace vug
