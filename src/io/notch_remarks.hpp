#pragma once
// Notches that do not stay as narrow as a case says.
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

/// A line for each notch that [damage], which the scene has, widens at its first update. `element_size`: mean edge of
/// the rock's triangles, m.
std::vector<std::string> remarks_on_notches(const Scene& scene, double element_size);

}  // namespace vug
