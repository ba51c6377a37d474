#pragma once
// Three minerals, one of them inert, and a second acid in the small rock of the tests, as overrides.
#include <string>
#include <vector>

namespace vug::test {

inline std::vector<std::string> minerals_of_small_rock() {
  return {
      "mineral.0={name=\"calcite\", rate_constant=2.0, activation_energy=30000, conductivity=9, heat_capacity=800,"
      " molar_volume=6e-4, shapes=[{type=\"rectangle\", from=[0, 0.006], to=[0.02, 0.014]}]}",
      "mineral.1={name=\"dolomite\", order=0.7, equilibrium_constant=inf, stoichiometry=2, conductivity=12,"
      " shapes=[{type=\"disc\", centre=[0.004, 0.004], radius=0.003}],"
      " further=[{reactant=\"L3\", rate_constant=3.0}]}",
      "mineral.2={name=\"quartz\", inert=true, density=2650,"
      " shapes=[{type=\"rectangle\", from=[0.003, 0.009], to=[0.006, 0.012]}]}",
      "solute.species.2={name=\"L3\", diffusivity=4e-4}",
      "reaction.further.0={reactant=\"L3\", product=\"L2\", rate_constant=0.5, equilibrium_constant=1e5}",
      "boundary.injection.solute.concentration.L3=1000"};
}

/// The same for a command line.
inline std::string minerals_on_command_line() {
  std::string line;
  for (const std::string& choice : minerals_of_small_rock()) line += " --set '" + choice + "'";
  return line;
}

}  // namespace vug::test
