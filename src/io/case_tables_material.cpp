// The materials of the rock: [mechanics.bond], young_modulus and poisson_ratio, and [[mechanics.material]] for regions.
#include "dem/elasticity.hpp"
#include "dem/toughness.hpp"
#include "io/detail/case_tables.hpp"

namespace vug {
namespace {

/// Reads the bond parameters that a material may have of its own; their defaults are those of the rock.
template <class Read>
void read_strengths(BondParameters& bond, const Read& read) {
  read("normal_strength", bond.normal_strength, unit::pascal, range::not_negative);
  read("cohesion", bond.cohesion, unit::pascal, range::not_negative);
  read("internal_friction", bond.internal_friction, unit::none, range::between(0, 10));
  read("fracture_energy_I", bond.fracture_energy_I, unit::newton_per_metre, range::positive);
  read("fracture_energy_II", bond.fracture_energy_II, unit::newton_per_metre, range::positive);
}

template <class Read>
void read_moduli(BondParameters& bond, const Read& read) {
  read("normal_modulus", bond.normal_modulus, unit::pascal, range::positive);
  read("tangential_modulus", bond.tangential_modulus, unit::pascal, range::positive);
}

/// Reads E and nu, which replace the moduli of the bonds. Where only one is given, the other follows from these moduli.
void read_elasticity(const TomlCursor& table, const TomlCursor& bonds, BondParameters& bond) {
  std::optional<double> young, poisson;
  table.read("young_modulus", young, unit::pascal, range::positive);
  table.read("poisson_ratio", poisson, unit::none, range::between(0, 0.8));
  if (!young && !poisson) return;
  const char* given = young ? "young_modulus" : "poisson_ratio";
  for (const char* modulus : {"normal_modulus", "tangential_modulus"})
    if (bonds.has(modulus)) bonds.fail(modulus, "stands beside " + table.inside(given) + "; give one of the two");
  const Elasticity of_bonds = elasticity_of(bond);
  bond = with_elasticity(bond, {young.value_or(of_bonds.young_modulus), poisson.value_or(of_bonds.poisson_ratio)});
}

/// Reads a number of a material, which is that of the rock where it is absent.
struct OwnNumber {
  const TomlCursor& table;
  void operator()(const char* key, double& value, Unit unit, Range range) const {
    table.read_own(key, value, unit, range);
  }
};

void read_material(const TomlCursor& table, MechanicsSection& mechanics) {
  const MechanicsParameters& rock = mechanics.parameters;
  const RockRegion region = read_region(table, FormOf::rock);
  RockMaterial material{rock.density, rock.thermal_expansion, rock.bond};
  const OwnNumber own{table};
  own("density", material.density, unit::kilogram_per_cubic_metre, range::positive);
  own("thermal_expansion", material.thermal_expansion, unit::per_kelvin, range::between(0, 1e-2));
  const TomlCursor bonds = table.table("bond");
  const OwnNumber of_bonds{bonds};
  read_moduli(material.bond, of_bonds);
  read_strengths(material.bond, of_bonds);
  of_bonds("damping", material.bond.damping, unit::second_per_metre, range::not_negative);
  read_elasticity(table, bonds, material.bond);
  mechanics.parameters.materials.push_back(material);
  mechanics.regions.push_back(region);
}

/// Reads [mechanics.bond]. Returns the path ratio, by which the fracture energies of the rock are divided for the
/// bonds.
double read_bond(const TomlCursor& table, BondParameters& bond) {
  const auto read = [&](const char* key, double& value, Unit unit, Range range) {
    table.read(key, value, unit, range);
  };
  read_moduli(bond, read);
  table.read("length_factor", bond.length_factor, unit::none, range::positive_to(10));
  read_strengths(bond, read);
  double path_ratio = generated_path_ratio;
  table.read("path_ratio", path_ratio, unit::none, range::between(1, 10));
  table.read("damping", bond.damping, unit::second_per_metre, range::not_negative);
  read_weibull_shape(table, bond);
  table.read("seed", bond.seed);
  return path_ratio;
}

}  // namespace

void read_weibull_shape(const TomlCursor& bonds, BondParameters& bond) {
  bonds.read("weibull_shape", bond.weibull_shape, unit::none, range::between(0, 1000));
  if (bond.weibull_shape > 0 && bond.weibull_shape < 0.5)
    bonds.fail("weibull_shape", "must be 0 (no scatter) or 0.5 ... 1000");
}

void read_materials(const TomlCursor& table, MechanicsSection& mechanics) {
  MechanicsParameters& rock = mechanics.parameters;
  const TomlCursor bonds = table.table("bond");
  const double path_ratio = read_bond(bonds, rock.bond);
  read_elasticity(table, bonds, rock.bond);
  for (const TomlCursor& element : table.tables("material")) read_material(element, mechanics);
  rock.bond = bonds_of_rock(rock.bond, path_ratio);
  for (RockMaterial& material : rock.materials) material.bond = bonds_of_rock(material.bond, path_ratio);
}

}  // namespace vug
