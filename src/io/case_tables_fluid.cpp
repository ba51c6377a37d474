// [flow], [heat], [solute], [reaction]: the fluid in the pores and its reaction with their walls.
#include "io/detail/case_tables.hpp"
#include "io/detail/nearest_name.hpp"

#include <fmt/format.h>

namespace vug {

namespace {

/// Reads k_r^0, or computes it from Da = k_r^0 l / D of the reactant (Eq. 13).
void read_rate(const TomlCursor& table, const std::optional<SoluteSection>& solute, ReactionSection& reaction) {
  std::optional<double> rate;
  table.read("rate_constant", rate, unit::metre_per_second, range::not_negative);
  table.read("damkohler", reaction.damkohler, unit::none, range::between(0, 1e12));
  table.read("length", reaction.length, unit::metre, range::positive);
  if (table.describing()) return;
  if (rate && reaction.damkohler) table.fail("damkohler", "stands beside reaction.rate_constant; give one of the two");
  if (rate && reaction.length)
    table.fail("length", "belongs to reaction.damkohler, but the rate is given by reaction.rate_constant");
  if (!rate && !reaction.damkohler) {
    table.fail("rate_constant",
               "is missing; give reaction.rate_constant (m/s), or reaction.damkohler with reaction.length (m)");
  }
  if (reaction.damkohler && !reaction.length) {
    table.fail("length", "is missing; reaction.damkohler needs the length it is formed with (m): k = Da D / length");
  }
  if (rate) reaction.rate_constant = *rate;
  if (!reaction.damkohler || !solute) return;
  for (const Species& species : solute->species) {
    if (species.name == reaction.reactant)
      reaction.rate_constant = *reaction.damkohler * species.diffusivity / *reaction.length;
  }
}

}  // namespace

namespace {

/// Reads the viscosity: one of kinematic, dynamic and a table over the temperature.
void read_viscosity(const TomlCursor& table, FlowSection& flow) {
  std::optional<double> kinematic, dynamic;
  table.read("viscosity", kinematic, unit::square_metre_per_second, range::positive);
  table.read("dynamic_viscosity", dynamic, unit::pascal_second, range::positive);
  table.read_curve("viscosity_table", flow.viscosity_table, unit::kelvin, unit::square_metre_per_second,
                   range::positive);
  table.read("viscosity_activation_energy", flow.viscosity_activation_energy, unit::joule_per_mole,
             range::not_negative);
  if (table.describing()) return;
  const bool from_table = !flow.viscosity_table.empty();
  if (!kinematic && !dynamic && !from_table)
    table.fail(
        "viscosity",
        "is missing; give flow.viscosity (kinematic, m2/s), flow.dynamic_viscosity (Pa s) or flow.viscosity_table");
  if (dynamic && kinematic) table.fail("dynamic_viscosity", "stands beside flow.viscosity; give one of the two");
  if (from_table && (kinematic || dynamic))
    table.fail("viscosity_table", fmt::format("stands beside flow.{}; give one of the two",
                                              kinematic ? "viscosity" : "dynamic_viscosity"));
  if (from_table && flow.viscosity_activation_energy != 0)
    table.fail("viscosity_activation_energy", "stands beside flow.viscosity_table; give one of the two");
  if (!from_table) flow.viscosity = kinematic ? *kinematic : *dynamic / flow.density;
}

}  // namespace

FlowSection read_flow(const TomlCursor& table) {
  FlowSection flow;
  table.read("density", flow.density, unit::kilogram_per_cubic_metre, range::positive);
  read_viscosity(table, flow);
  table.read("gravity", flow.gravity, unit::metre_per_square_second);
  table.read("thermal_expansion", flow.thermal_expansion, unit::per_kelvin, range::between(-0.1, 0.1));
  std::optional<double> reference;
  table.read("reference_temperature", reference, unit::kelvin, range::positive);
  flow.reference_temperature = reference.value_or(0);
  table.choose("collision", flow.collision,
               {{"trt", Collision::trt},
                {"lallemand_luo", Collision::lallemand_luo},
                {"bgk", Collision::bgk},
                {"regularised", Collision::regularised}});
  table.read("body_force", flow.body_force, unit::metre_per_square_second);
  table.read("initial_pressure", flow.initial_pressure, unit::pascal, range::not_negative);
  table.read("speed_limit", flow.speed_limit, unit::none, range::between(0, 0.5));
  table.read("pressure_scale", flow.pressure_scale, unit::none, range::between(1, 1e6));
  return flow;
}

HeatSection read_heat(const TomlCursor& table) {
  HeatSection heat;
  table.need("fluid_diffusivity", heat.fluid_diffusivity, unit::square_metre_per_second, range::positive);
  table.need("solid_diffusivity", heat.solid_diffusivity, unit::square_metre_per_second, range::positive);
  table.read("fluid_density", heat.fluid_density, unit::kilogram_per_cubic_metre, range::positive);
  table.read("solid_density", heat.solid_density, unit::kilogram_per_cubic_metre, range::positive);
  table.read("fluid_heat_capacity", heat.fluid_heat_capacity, unit::joule_per_kilogram_kelvin, range::positive);
  table.read("solid_heat_capacity", heat.solid_heat_capacity, unit::joule_per_kilogram_kelvin, range::positive);
  table.read("initial_temperature", heat.initial_temperature, unit::kelvin, range::positive);
  table.choose("velocity_set", heat.velocity_set,
               {{"d2q5", ScalarVelocitySet::d2q5}, {"d2q9", ScalarVelocitySet::d2q9}});
  return heat;
}

namespace {

/// Names with which other columns of the history begin (balances, and flows through sides).
constexpr const char* taken_by_columns[] = {"heat",        "fluid_mass",    "mass", "solid_volume", "dissolved_volume",
                                            "rock_volume", "rock_dissolved"};

}  // namespace

SoluteSection read_solute(const TomlCursor& table) {
  SoluteSection solute;
  table.choose("velocity_set", solute.velocity_set,
               {{"d2q5", ScalarVelocitySet::d2q5}, {"d2q9", ScalarVelocitySet::d2q9}});
  table.read("relaxation_time", solute.relaxation_time, unit::none, Range{.low = 0.5, .high = 100, .low_open = true});
  table.read("advective_form", solute.advective_form);
  table.read("face_exchange", solute.face_exchange);
  if (solute.face_exchange && (!solute.advective_form || solute.velocity_set != ScalarVelocitySet::d2q5))
    table.fail("face_exchange", "belongs to the advective form on d2q5 (solute.advective_form, solute.velocity_set)");
  constexpr std::size_t most = 64;  // every species is a lattice field of its own
  for (const TomlCursor& element : table.tables("species")) {
    if (solute.species.size() == most)
      element.fail("name", fmt::format("is one species too many; at most {} are accepted", most));
    Species species;
    element.need("name", species.name);
    element.need("diffusivity", species.diffusivity, unit::square_metre_per_second, range::positive);
    element.read("initial", species.initial, unit::mole_per_cubic_metre, range::not_negative);
    check_name(element, species.name, solute.species, "species");
    for (const char* taken : taken_by_columns)
      if (species.name == taken) element.fail("name", "begins other columns of the history; choose another");
    solute.species.push_back(species);
  }
  if (solute.species.empty()) table.fail("species", "is missing; [solute] needs at least one [[solute.species]]");
  return solute;
}

namespace {

/// 1/K_eq.
double read_inverse_equilibrium(const TomlCursor& table) {
  double equilibrium_constant = std::numeric_limits<double>::infinity();
  table.read("equilibrium_constant", equilibrium_constant, equilibrium_unit, equilibrium_range);
  return 1 / equilibrium_constant;
}

FurtherReactant read_further(const TomlCursor& table) {
  FurtherReactant further;
  table.need("reactant", further.reactant);
  table.read("product", further.product);
  table.need("rate_constant", further.rate_constant, unit::metre_per_second, range::not_negative);
  table.read("activation_energy", further.activation_energy, unit::joule_per_mole, range::not_negative);
  further.inverse_equilibrium_constant = read_inverse_equilibrium(table);
  table.read("order", further.order, unit::none, range::positive_to(4));
  table.read("stoichiometry", further.stoichiometry, unit::none, range::positive_to(100));
  table.read("product_stoichiometry", further.product_stoichiometry, unit::none, range::positive_to(100));
  return further;
}

}  // namespace

ReactionSection read_reaction(const TomlCursor& table, const std::optional<SoluteSection>& solute) {
  ReactionSection reaction;
  table.need("reactant", reaction.reactant);
  table.read("product", reaction.product);
  read_rate(table, solute, reaction);
  table.read("activation_energy", reaction.activation_energy, unit::joule_per_mole, range::not_negative);
  table.read("reference_temperature", reaction.reference_temperature, unit::kelvin, range::positive);
  table.read("temperature", reaction.temperature, unit::kelvin, range::positive);
  reaction.inverse_equilibrium_constant = read_inverse_equilibrium(table);
  table.read("order", reaction.order, unit::none, range::positive_to(4));
  table.read("reference_concentration", reaction.reference_concentration, unit::mole_per_cubic_metre, range::positive);
  table.read("stoichiometry", reaction.stoichiometry, unit::none, range::positive_to(100));
  table.read("product_stoichiometry", reaction.product_stoichiometry, unit::none, range::positive_to(100));
  table.read("molar_volume", reaction.molar_volume, unit::cubic_metre_per_mole, range::not_negative);
  table.choose("wall", reaction.wall, {{"kinetic", ReactiveWallLaw::kinetic}, {"paper", ReactiveWallLaw::paper}});
  table.read("surface_normal", reaction.surface_normal);
  table.choose("birth_fill", reaction.birth_fill, {{"mean", BirthFill::mean}, {"split", BirthFill::split}});
  for (const TomlCursor& element : table.tables("further")) reaction.further.push_back(read_further(element));
  return reaction;
}

}  // namespace vug
