#include "io/named_temperatures.hpp"

#include "io/each_boundary.hpp"

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

}  // namespace vug
