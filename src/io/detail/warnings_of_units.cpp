// Warnings about numbers that are probably meant in another unit, or from another zero.
#include "io/detail/case_checks.hpp"
#include "io/each_boundary.hpp"
#include "io/named_temperatures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vug {
namespace {

/// A temperature that is probably meant in degrees Celsius: no fluid of rock is as cold, and geothermal rock as hot.
void warn_about_kelvin(Scene& scene) {
  const auto named = named_temperatures(scene);
  const double coldest = *std::min_element(named.begin(), named.end());
  if (coldest < 250)
    scene.warnings.push_back(
        fmt::format("[heat] has a temperature of {0:g} K: numbers without a unit are in kelvin; in "
                    "degrees Celsius it is written \"{0:g} degC\"",
                    coldest));
}

/// A stress or modulus that is probably meant in megapascals: `least` is far below that of any rock.
void remark_on_pascals(Scene& scene, const std::string& what, double value, double least) {
  if (value > 0 && value < least)
    scene.warnings.push_back(
        fmt::format("{} is {:g} Pa: numbers without a unit are in pascals; in megapascals it is written \"{:g} MPa\"",
                    what, value, value));
}

void warn_about_pascals(Scene& scene) {
  constexpr double softest = 1e6, weakest = 1e3;  // Pa
  const auto look = [&](const std::string& of, const BondParameters& bond) {
    remark_on_pascals(scene, of + ": Young's modulus or bond.normal_modulus", bond.normal_modulus, softest);
    remark_on_pascals(scene, of + ": bond.normal_strength", bond.normal_strength, weakest);
    remark_on_pascals(scene, of + ": bond.cohesion", bond.cohesion, weakest);
  };
  const MechanicsParameters& rock = scene.mechanics->parameters;
  look("mechanics", rock.bond);
  for (std::size_t m = 0; m < rock.materials.size(); ++m)
    look(fmt::format("mechanics.material.{}", m), rock.materials[m].bond);
  if (scene.laboratory) remark_on_pascals(scene, "laboratory.confinement", scene.laboratory->confinement, weakest);
}

/// Pressures that are probably meant above the initial one, as on a gauge.
void warn_about_gauge_pressures(Scene& scene) {
  const double initial = scene.flow->initial_pressure;
  bool given = false;
  double largest = 0;
  for_each_boundary(scene, [&](const BoundarySection& at) {
    if (at.flow.kind != FlowBoundaryKind::pressure) return;
    given = true;
    largest = std::max(largest, std::abs(at.flow.pressure.peak()));
  });
  if (given && largest < 0.1 * initial)
    scene.warnings.push_back(
        fmt::format("all pressures given are at most {:g} Pa: pressures are absolute, and fluid at rest has "
                    "flow.initial_pressure = {:g} Pa",
                    largest, initial));
}

}  // namespace

void warn_about_units(Scene& scene) {
  if (scene.heat) warn_about_kelvin(scene);
  if (scene.mechanics) warn_about_pascals(scene);
  if (scene.flow) warn_about_gauge_pressures(scene);
}

}  // namespace vug
