#pragma once
// The reaction of the fluid with the walls of the rock.
#include "base/choices.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vug {

/// How fast a reactant dissolves a solid.
struct RateLaw {
  double rate_constant = 0;      ///< k_r^0 at the reference temperature, m/s (also when given by Da and length)
  double activation_energy = 0;  ///< J/mol
  double inverse_equilibrium_constant = 0;  ///< 1/K_eq; 0 = irreversible
  double order = 1;                         ///< n in k C_ref (C/C_ref)^n
  double stoichiometry = 1;                 ///< moles of reactant that a mole of the solid consumes
  double product_stoichiometry = 1;         ///< moles of product that a mole of the solid gives

  /// Moles of product for each mole of reactant.
  double product_yield() const { return product_stoichiometry / stoichiometry; }
};
/// One more reactant at the same walls; it may have species in common with others.
struct FurtherReactant : RateLaw {
  std::string reactant;                ///< name of a species
  std::optional<std::string> product;  ///< name of a species
};

struct ReactionSection : RateLaw {
  std::string reactant;                ///< name of a species
  std::optional<std::string> product;  ///< name of a species
  std::vector<FurtherReactant> further;
  double reference_concentration = 1000;  ///< C_ref of orders other than 1, mol/m3
  double reference_temperature = 273.15;  ///< K
  double temperature = 293.15;            ///< K, of the wall where the case has no [heat]
  double molar_volume = 0;                ///< of the solid, m3/mol; 0 = the wall reacts but does not dissolve
  std::optional<double> damkohler;        ///< as given, Da = k_r^0 length / D (Eq. 13)
  std::optional<double> length;           ///< m, l_c of the Damkohler number
  ReactiveWallLaw wall = ReactiveWallLaw::kinetic;
  bool surface_normal = true;  ///< correct the area of staircases
  BirthFill birth_fill = BirthFill::mean;
};

}  // namespace vug
