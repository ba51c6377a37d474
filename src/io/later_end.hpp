#pragma once
// Whether two texts of a case differ in nothing but the end of the run.
#include "io/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vug {

/// [time] of a case that `text` and its overrides give, where every other value is that of `scene` and the end is given
/// by the same key; otherwise nothing. Layout and comments do not count.
std::optional<TimeSection> time_of_same_case(const Scene& scene, const std::string& text,
                                             const std::vector<std::string>& overrides);

}  // namespace vug
