#pragma once
// The range of temperatures that a case names.
#include "io/scene.hpp"

namespace vug {

struct TemperatureRange {
  double coldest = 0, hottest = 0;  ///< K
  double span() const { return hottest - coldest; }
};

/// From the temperatures at the start and on all sides and openings. `scene` has [heat].
TemperatureRange named_range(const Scene& scene);

/// The same with the difference that a heat flux maintains across a layer of fluid as thick as the lattice is long.
TemperatureRange temperature_range(const Scene& scene);

/// Lowest kinematic viscosity in the temperature_range, m2/s. `scene` has [flow].
double lowest_viscosity(const Scene& scene);

/// Highest one in the named_range, m2/s.
double highest_viscosity(const Scene& scene);

}  // namespace vug
