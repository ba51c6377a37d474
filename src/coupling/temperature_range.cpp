#include "coupling/temperature_range.hpp"

#include <algorithm>

namespace vug {

TemperatureRange temperature_range(const Scene& scene) {
  const HeatSection& heat = *scene.heat;
  TemperatureRange range{heat.initial_temperature, heat.initial_temperature};
  const double conductivity = heat.fluid_density * heat.fluid_heat_capacity * heat.fluid_diffusivity;
  const double length = std::max(scene.lattice.length_x, scene.lattice.length_y);
  double warmed = 0, cooled = 0;
  const auto add = [&](const HeatBoundary& boundary) {
    if (boundary.kind == HeatCondition::temperature || boundary.kind == HeatCondition::convection) {
      range.coldest = std::min(range.coldest, boundary.temperature.lowest());
      range.hottest = std::max(range.hottest, boundary.temperature.highest());
    }
    if (boundary.kind != HeatCondition::flux) return;
    warmed = std::max(warmed, boundary.flux.highest() * length / conductivity);
    cooled = std::max(cooled, -boundary.flux.lowest() * length / conductivity);
  };
  for (const BoundarySection* side : {&scene.left, &scene.right, &scene.bottom, &scene.top}) add(side->heat);
  for (const InjectionSection& injection : scene.injections) add(injection.conditions.heat);
  for (const OpeningSection& opening : scene.openings) add(opening.conditions.heat);
  range.hottest += warmed;
  range.coldest = std::max(1.0, range.coldest - cooled);
  return range;
}

}  // namespace vug
