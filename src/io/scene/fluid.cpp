#include "io/scene/fluid.hpp"

#include "io/time_table.hpp"
#include "io/units.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

double FlowSection::viscosity_at(double temperature) const {
  if (!viscosity_table.empty()) {
    std::vector<double> at, value;
    for (const auto& [kelvin, nu] : viscosity_table) {
      at.push_back(kelvin);
      value.push_back(nu);
    }
    return TimeTable(at, value).at(temperature);
  }
  return viscosity *
         std::exp(viscosity_activation_energy / gas_constant * (1 / temperature - 1 / reference_temperature));
}

double FlowSection::lowest_viscosity(double coldest, double hottest) const {
  if (!viscosity_varies()) return viscosity;
  double lowest = std::min(viscosity_at(coldest), viscosity_at(hottest));
  for (const auto& [kelvin, nu] : viscosity_table)
    if (kelvin > coldest && kelvin < hottest) lowest = std::min(lowest, nu);
  return lowest;
}

}  // namespace vug
