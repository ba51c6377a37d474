// [[mineral]]: where the minerals of the rock are and their properties, with the rates of the reactants on each
// mineral.
#include "io/detail/case_tables.hpp"
#include "io/detail/nearest_name.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vug {
namespace {

constexpr std::size_t most_minerals = 64;  // their numbers are bytes, and each has its own columns in the history

constexpr std::array<std::string_view, 6> rate_keys = {"rate_constant", "activation_energy", "equilibrium_constant",
                                                       "order",         "stoichiometry",     "product_stoichiometry"};

std::vector<std::string> reactants_of(const ReactionSection& reaction) {
  std::vector<std::string> names{reaction.reactant};
  for (const FurtherReactant& further : reaction.further) names.push_back(further.reactant);
  return names;
}

/// [[mineral.further]]: rates of the further reactants on this mineral.
void read_further_rates(const TomlCursor& table, const ReactionSection& reaction, MineralSection& mineral) {
  const std::vector<std::string> names = reactants_of(reaction);
  std::vector<bool> seen(names.size(), false);
  for (const TomlCursor& element : table.tables("further")) {
    std::string reactant;
    element.need("reactant", reactant);
    RateLaw unused;
    std::size_t which = 0;
    if (!table.describing()) {
      which = static_cast<std::size_t>(std::find(names.begin() + 1, names.end(), reactant) - names.begin());
      if (which == names.size())
        element.fail("reactant", "is not that of a [[reaction.further]]" +
                                     suggestion(reactant, std::vector<std::string>(names.begin() + 1, names.end())));
      if (seen[which]) element.fail("reactant", "has its rates given twice for this mineral");
      seen[which] = true;
      if (mineral.inert) element.fail("reactant", "stands beside inert = true");
    }
    read_own_rate(element, table.describing() ? unused : mineral.rates[which]);
  }
}

void read_reaction_of(const TomlCursor& table, const std::optional<ReactionSection>& reaction,
                      MineralSection& mineral) {
  table.read("inert", mineral.inert);
  if (!reaction && !table.describing()) {
    for (const std::string_view key : rate_keys) table.refuse(key, "needs the table [reaction]");
    for (const char* key : {"inert", "molar_volume", "further"}) table.refuse(key, "needs the table [reaction]");
    return;
  }
  const ReactionSection of_rock = reaction.value_or(ReactionSection{});
  mineral.rates.push_back(of_rock);
  for (const FurtherReactant& further : of_rock.further) mineral.rates.push_back(further);
  if (mineral.inert && !table.describing()) {
    for (const std::string_view key : rate_keys) table.refuse(key, "stands beside inert = true");
    for (RateLaw& rate : mineral.rates) rate.rate_constant = 0;
  }
  mineral.molar_volume = of_rock.molar_volume;
  read_own_rate(table, mineral.rates[0]);
  table.read_own("molar_volume", mineral.molar_volume, unit::cubic_metre_per_mole, range::positive);
  read_further_rates(table, of_rock, mineral);
}

void read_heat_of(const TomlCursor& table, const std::optional<HeatSection>& heat, MineralSection& mineral) {
  if (!heat && !table.describing()) {
    for (const char* key : {"conductivity", "density", "heat_capacity"}) table.refuse(key, "needs the table [heat]");
    return;
  }
  const HeatSection of_rock = heat.value_or(HeatSection{});
  double conductivity = of_rock.solid_diffusivity * of_rock.solid_density * of_rock.solid_heat_capacity;
  mineral.density = of_rock.solid_density;
  mineral.heat_capacity = of_rock.solid_heat_capacity;
  table.read_own("conductivity", conductivity, unit::watt_per_metre_kelvin, range::positive);
  table.read_own("density", mineral.density, unit::kilogram_per_cubic_metre, range::positive);
  table.read_own("heat_capacity", mineral.heat_capacity, unit::joule_per_kilogram_kelvin, range::positive);
  mineral.diffusivity = conductivity / (mineral.density * mineral.heat_capacity);
}

void read_name(const TomlCursor& table, const std::vector<MineralSection>& earlier, MineralSection& mineral) {
  table.need("name", mineral.name);
  if (table.describing()) return;
  if (earlier.size() == most_minerals)
    table.fail("name", fmt::format("is one mineral too many; at most {} are accepted", most_minerals));
  check_name(table, mineral.name, earlier, "mineral");
  for (const char* taken : {"rock", "solid", "dissolved"})
    if (mineral.name == taken) table.fail("name", "has a meaning of its own; choose another");
}

}  // namespace

void read_own_rate(const TomlCursor& table, RateLaw& rate) {
  table.read_own("rate_constant", rate.rate_constant, unit::metre_per_second, range::not_negative);
  table.read_own("activation_energy", rate.activation_energy, unit::joule_per_mole, range::not_negative);
  std::optional<double> equilibrium_constant;
  table.read("equilibrium_constant", equilibrium_constant, equilibrium_unit, equilibrium_range);
  if (equilibrium_constant) rate.inverse_equilibrium_constant = 1 / *equilibrium_constant;
  table.read_own("order", rate.order, unit::none, range::positive_to(4));
  table.read_own("stoichiometry", rate.stoichiometry, unit::none, range::positive_to(100));
  table.read_own("product_stoichiometry", rate.product_stoichiometry, unit::none, range::positive_to(100));
}

MineralSection read_mineral(const TomlCursor& table, const Scene& scene) {
  MineralSection mineral;
  read_name(table, scene.minerals, mineral);
  for (const TomlCursor& shape : table.tables("shapes")) mineral.regions.push_back(read_region(shape, FormOf::mesh));
  table.read("labels", mineral.labels);
  if (!table.describing() && mineral.regions.empty() && mineral.labels.empty())
    table.fail("shapes", "is missing; a mineral is where [[mineral.shapes]] or labels say");
  read_reaction_of(table, scene.reaction, mineral);
  read_heat_of(table, scene.heat, mineral);
  return mineral;
}

}  // namespace vug
