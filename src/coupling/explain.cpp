#include "coupling/explain.hpp"

#include "coupling/geometry.hpp"

#include <fmt/format.h>

#include <iterator>

namespace vug {

namespace {

/// The rows of the table.
class Numbers {
 public:
  explicit Numbers(const LatticeUnits& units) : units_(units) {
    add("what", "in SI", "unit", "on the lattice", "in units of");
  }

  void put(const std::string& key, double value, const char* unit, double lattice, double one, const char* of) {
    add(key, fmt::format("{:.8g}", value), unit, fmt::format("{:.5g}", lattice), fmt::format("{:.4g} {}", one, of));
  }
  /// Adds a number that is its lattice value times `one`.
  void put(const std::string& key, double value, const char* unit, double one) {
    put(key, value, unit, value / one, one, unit);
  }
  void pressure(const std::string& key, double value) {
    put(key, value, "Pa", units_.lattice_pressure(value), units_.pressure(), "Pa above the initial pressure");
  }
  void temperature(const std::string& key, double value) {
    put(key, value, "K", units_.lattice_temperature(value), 1, "K above the initial temperature");
  }
  std::string text() const { return text_; }

 private:
  void add(const std::string& key, const std::string& value, const std::string& unit, const std::string& lattice,
           const std::string& one) {
    fmt::format_to(std::back_inserter(text_), "{:<44} {:>12} {:<10} {:>14}   {}\n", key, value, unit, lattice, one);
  }
  LatticeUnits units_;
  std::string text_;
};

void explain_flow(const FlowSection& flow, const LatticeUnits& units, Numbers& numbers) {
  numbers.put("flow.density", flow.density, "kg/m3", units.fluid_density);
  numbers.put("flow.viscosity", flow.viscosity, "m2/s", units.diffusivity());
  for (int axis = 0; axis < 2; ++axis)
    if (flow.body_force[axis] != 0)
      numbers.put(axis == 0 ? "flow.body_force, along x" : "flow.body_force, along y", flow.body_force[axis], "m/s2",
                  units.acceleration() * units.pressure_scale);
}

/// Adds the conditions of flow, heat and solutes at a side, an injection or an opening.
void explain_side(const Scene& scene, const Stretch& stretch, const LatticeUnits& units, Numbers& numbers) {
  const std::string key = "boundary." + stretch.name + ".";
  const FlowBoundary& flow = stretch.conditions.flow;
  if (scene.flow && flow.kind == FlowBoundaryKind::pressure)
    numbers.pressure(key + "flow.pressure", flow.pressure.peak());
  if (scene.flow && flow.peak_speed() > 0)
    numbers.put(key + "flow.velocity", flow.peak_speed(), "m/s", units.velocity());
  if (scene.flow && flow.has_rate())
    numbers.put(key + "flow, volume per depth", flow.peak_rate(scene.flow->density), "m2/s", units.diffusivity());
  const HeatBoundary& heat = stretch.conditions.heat;
  if (scene.heat && (heat.kind == HeatCondition::temperature || heat.kind == HeatCondition::convection))
    numbers.temperature(key + "heat.temperature", heat.temperature.peak());
  if (scene.heat && heat.kind == HeatCondition::flux)
    numbers.put(key + "heat.flux", heat.flux.peak(), "W/m2",
                scene.heat->fluid_density * scene.heat->fluid_heat_capacity * units.velocity());
  const SoluteBoundary& solute = stretch.conditions.solute;
  for (const auto& [name, value] : solute.concentration)
    numbers.put(key + "solute.concentration." + name, value.peak(), "mol/m3", units.concentration);
  for (const auto& [name, value] : solute.flux)
    numbers.put(key + "solute.flux." + name, value.peak(), "mol/(m2 s)", units.concentration * units.velocity());
}

}  // namespace

std::string explain(const Scene& scene, const LatticeUnits& units) {
  Numbers numbers(units);
  numbers.put("lattice.spacing", units.spacing, "m", units.spacing);
  numbers.put("lattice.time_step", units.time_step, "s", units.time_step);
  if (scene.flow) explain_flow(*scene.flow, units, numbers);
  if (scene.heat) {
    numbers.temperature("heat.initial_temperature", scene.heat->initial_temperature);
    numbers.put("thermal diffusivity of the fluid", scene.heat->fluid_diffusivity, "m2/s", units.diffusivity());
    numbers.put("thermal diffusivity of the rock", scene.heat->solid_diffusivity, "m2/s", units.diffusivity());
  }
  if (scene.solute)
    for (const Species& species : scene.solute->species) {
      numbers.put("diffusivity of " + species.name, species.diffusivity, "m2/s", units.diffusivity());
      numbers.put("initial concentration of " + species.name, species.initial, "mol/m3", units.concentration);
    }
  if (scene.reaction && scene.reaction->rate_constant > 0)
    numbers.put("reaction.rate_constant", scene.reaction->rate_constant, "m/s", units.rate_constant());
  if (scene.rock) numbers.put("rock.element_size", scene.rock->element_size, "m", units.spacing);
  for (const Stretch& stretch : boundary_stretches(scene)) explain_side(scene, stretch, units, numbers);
  for (std::size_t o = 0; o < scene.openings.size(); ++o) {
    Stretch surface;
    surface.name = "shape." + scene.geometry.shapes[scene.openings[o].shape].name;
    surface.conditions = scene.openings[o].conditions;
    explain_side(scene, surface, units, numbers);
  }
  return numbers.text();
}

}  // namespace vug
