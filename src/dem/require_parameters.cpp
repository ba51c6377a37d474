#include "dem/require_parameters.hpp"

#include "base/require.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace vug {

namespace {

constexpr double unbounded = std::numeric_limits<double>::max();

void require_between(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;  // NaN fails
  throw InputError("mechanics." + std::string(name) + " = " + std::to_string(value) + ", expected " +
                   (high == unbounded ? "at least " + std::to_string(low)
                                      : "between " + std::to_string(low) + " and " + std::to_string(high)));
}

void require_positive(const char* name, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw InputError("mechanics." + std::string(name) + " = " + std::to_string(value) + ", expected a positive number");
}

void require_bond(const BondParameters& bond) {
  require_positive("bond.normal_modulus", bond.normal_modulus);
  require_between("bond.tangential_modulus", bond.tangential_modulus, 0, unbounded);
  require_positive("bond.length_factor", bond.length_factor);
  require_between("bond.normal_strength", bond.normal_strength, 0, unbounded);
  require_between("bond.cohesion", bond.cohesion, 0, unbounded);
  require_between("bond.internal_friction", bond.internal_friction, 0, unbounded);
  require_between("bond.fracture_energy_I", bond.fracture_energy_I, 0, unbounded);
  require_between("bond.fracture_energy_II", bond.fracture_energy_II, 0, unbounded);
  require_between("bond.damping", bond.damping, 0, unbounded);
  if (bond.weibull_shape != 0) require_between("bond.weibull_shape", bond.weibull_shape, 0.1, unbounded);
}

}  // namespace

void require_parameters(const MechanicsParameters& p) {
  require_positive("density", p.density);
  require_between("thermal_expansion", p.thermal_expansion, -1e-2, 1e-2);
  require_between("local_damping", p.local_damping, 0, 1);
  require_between("mass_scaling", p.mass_scaling, 1, unbounded);
  require_between("rest_tolerance", p.rest_tolerance, 0, 1);
  require_bond(p.bond);
  for (const RockMaterial& material : p.materials) {
    require_positive("material.density", material.density);
    require_between("material.thermal_expansion", material.thermal_expansion, -1e-2, 1e-2);
    require_bond(material.bond);
  }
  const double radius = p.contact.radius_factor;
  if (!(radius > 0 && radius < 1))
    throw InputError("mechanics.contact.radius_factor = " + std::to_string(radius) +
                     ", expected between 0 and 1 (of the smallest inradius)");
  require_positive("contact.normal_stiffness", p.contact.normal_stiffness);
  require_between("contact.tangential_stiffness", p.contact.tangential_stiffness, 0, unbounded);
  require_between("contact.friction", p.contact.friction, 0, unbounded);
  require_between("contact.normal_damping", p.contact.normal_damping, 0, unbounded);
  require_between("contact.tangential_damping", p.contact.tangential_damping, 0, unbounded);
  require_between("chemical.failure_at", p.chemical.failure_at, 0, 1);
}

}  // namespace vug
