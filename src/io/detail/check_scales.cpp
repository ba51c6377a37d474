// Checks of scales: the diffusivities that spacing and time step give in lattice units, and strains by heat.
#include "io/detail/case_checks.hpp"
#include "io/named_temperatures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vug {
namespace {

// Limits of diffusivities in lattice units. Below `least` the relaxation time is numerically 1/2; a value above `most`
// can only be a typing error.
constexpr double least = 1e-12, most = 1e9;

void check_diffusivity(const TomlDocument& document, const LatticeSection& lattice, const std::string& key,
                       double value) {
  const double scaled = value * lattice.time_step / (lattice.spacing * lattice.spacing);
  if (scaled >= least && scaled <= most) return;
  document.fail("lattice.time_step",
                fmt::format("s turns {} = {:g} m2/s into {:.3g} lattice units (value time_step / spacing^2); {:g} ... "
                            "{:g} is accepted, and good ones lie between 1e-3 and 1",
                            key, value, scaled, least, most));
}

/// A viscosity that depends on the temperature must be between `least` and `most` in lattice units at every temperature
/// that the case names.
void check_law_of_viscosity(const TomlDocument& document, const Scene& scene) {
  const FlowSection& flow = *scene.flow;
  const char* key = flow.viscosity_table.empty() ? "flow.viscosity_activation_energy" : "flow.viscosity_table";
  for (const double temperature : named_temperatures(scene)) {
    const double viscosity = flow.viscosity_at(temperature);
    const double scaled = viscosity * scene.lattice.time_step / (scene.lattice.spacing * scene.lattice.spacing);
    if (scaled >= least && scaled <= most) continue;
    document.fail(key,
                  fmt::format("makes the viscosity at {:g} K {:.3g} m2/s, {:.3g} in lattice units (value time_step / "
                              "spacing^2); {:g} ... {:g} is accepted, and good ones lie between 1e-3 and 1",
                              temperature, viscosity, scaled, least, most));
  }
}

}  // namespace

void check_thermal_strain(const TomlDocument& document, const Scene& scene, double change) {
  const MechanicsParameters& rock = scene.mechanics->parameters;
  double expansion = rock.thermal_expansion;
  for (const RockMaterial& material : rock.materials) expansion = std::max(expansion, material.thermal_expansion);
  if (expansion * change < 1) return;
  document.fail_at(
      "mechanics.thermal_expansion",
      fmt::format("a thermal expansion of {:g} 1/K over {:g} K is a strain of {:.3g}: rock that shrinks so "
                  "far has no size left; limestone has about 8e-6 1/K",
                  expansion, change, expansion * change));
}

void check_scales(const TomlDocument& document, const Scene& scene) {
  const auto check = [&](const std::string& key, double value) {
    check_diffusivity(document, scene.lattice, key, value);
  };
  if (scene.flow) check("flow.viscosity", scene.flow->viscosity);
  if (scene.heat) {
    check("heat.fluid_diffusivity", scene.heat->fluid_diffusivity);
    check("heat.solid_diffusivity", scene.heat->solid_diffusivity);
  }
  if (scene.solute)
    for (std::size_t i = 0; i < scene.solute->species.size(); ++i)
      check(fmt::format("solute.species.{}.diffusivity", i), scene.solute->species[i].diffusivity);
  if (scene.heat && scene.mechanics) check_thermal_strain(document, scene, largest_named_change(scene));
  if (!scene.flow) return;
  if (scene.heat && scene.flow->viscosity_varies()) check_law_of_viscosity(document, scene);
  const double velocity = scene.lattice.spacing / scene.lattice.time_step;
  const double pressure = scene.flow->density * velocity * velocity;
  if (!std::isnormal(pressure) || !std::isnormal(pressure * scene.lattice.spacing))
    document.fail("lattice.time_step",
                  "s makes a unit of pressure, density (spacing / time_step)^2, that is no number");
}

}  // namespace vug
