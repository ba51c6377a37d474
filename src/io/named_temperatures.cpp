#include "io/named_temperatures.hpp"

#include "io/each_boundary.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

std::vector<double> named_temperatures(const Scene& scene) {
  std::vector<double> found{scene.heat->initial_temperature};
  for_each_boundary(scene, [&](const BoundarySection& given) {
    const HeatBoundary& heat = given.heat;
    if (heat.kind != HeatCondition::temperature && heat.kind != HeatCondition::convection) return;
    found.push_back(heat.temperature.lowest());
    found.push_back(heat.temperature.highest());
  });
  return found;
}

double largest_named_change(const Scene& scene) {
  double change = 0;
  for (const double temperature : named_temperatures(scene))
    change = std::max(change, std::abs(temperature - scene.heat->initial_temperature));
  return change;
}

}  // namespace vug
