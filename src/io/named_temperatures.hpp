#pragma once
// The temperatures that a case names.
#include "io/scene.hpp"

#include <vector>

namespace vug {

/// The temperature at the start, and the lowest and highest of every condition that gives temperatures, K. `scene` has
/// [heat].
std::vector<double> named_temperatures(const Scene& scene);

/// Largest difference of one of them from the temperature at the start, K.
double largest_named_change(const Scene& scene);

}  // namespace vug
