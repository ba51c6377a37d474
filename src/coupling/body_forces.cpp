#include "coupling/body_forces.hpp"

#include "coupling/temperature_range.hpp"

namespace vug {

BodyForces body_forces(const Scene& scene, const LatticeUnits& units) {
  const FlowSection& flow = *scene.flow;
  const bool buoyant = scene.heat && flow.buoyant();
  const TemperatureRange range = buoyant ? temperature_range(scene) : TemperatureRange{};
  BodyForces forces;
  for (int axis = 0; axis < 2; ++axis) {
    const auto at = [&](double temperature) {
      const double warmth = buoyant ? temperature - flow.reference_temperature : 0;
      const double acceleration = flow.body_force[axis] - flow.gravity[axis] * flow.thermal_expansion * warmth;
      return acceleration / (units.acceleration() * units.pressure_scale);
    };
    const double coldest = at(range.coldest), hottest = at(range.hottest);
    forces.range[axis] = Span{coldest, coldest}.with({hottest, hottest});
    forces.at_start[axis] = at(buoyant ? scene.heat->initial_temperature : 0);
  }
  return forces;
}

}  // namespace vug
