#include "coupling/temperature_range.hpp"

#include "io/each_boundary.hpp"
#include "io/named_temperatures.hpp"

#include <algorithm>

namespace vug {

TemperatureRange named_range(const Scene& scene) {
  const std::vector<double> named = named_temperatures(scene);
  const auto [coldest, hottest] = std::minmax_element(named.begin(), named.end());
  return {*coldest, *hottest};
}

TemperatureRange temperature_range(const Scene& scene) {
  const HeatSection& heat = *scene.heat;
  TemperatureRange range = named_range(scene);
  const double conductivity = heat.fluid_density * heat.fluid_heat_capacity * heat.fluid_diffusivity;
  const double length = std::max(scene.lattice.length_x, scene.lattice.length_y);
  double warmed = 0, cooled = 0;
  for_each_boundary(scene, [&](const BoundarySection& given) {
    if (given.heat.kind != HeatCondition::flux) return;
    warmed = std::max(warmed, given.heat.flux.highest() * length / conductivity);
    cooled = std::max(cooled, -given.heat.flux.lowest() * length / conductivity);
  });
  range.hottest += warmed;
  range.coldest = std::max(1.0, range.coldest - cooled);
  return range;
}

double lowest_viscosity(const Scene& scene) {
  if (!scene.heat) return scene.flow->viscosity;
  const TemperatureRange range = temperature_range(scene);
  return scene.flow->lowest_viscosity(range.coldest, range.hottest);
}

double highest_viscosity(const Scene& scene) {
  const FlowSection& flow = *scene.flow;
  if (!scene.heat || !flow.viscosity_varies()) return flow.viscosity;
  const TemperatureRange range = named_range(scene);
  double highest = std::max(flow.viscosity_at(range.coldest), flow.viscosity_at(range.hottest));
  for (const auto& [kelvin, nu] : flow.viscosity_table)
    if (kelvin > range.coldest && kelvin < range.hottest) highest = std::max(highest, nu);
  return highest;
}

}  // namespace vug
