#include "dem/materials.hpp"

#include "base/require.hpp"
#include "dem/elasticity.hpp"
#include "dem/extent.hpp"
#include "dem/particles.hpp"

#include <algorithm>
#include <cmath>

namespace vug {

namespace {

/// Modulus of two springs in series.
double in_series(double m_a, double h_a, double m_b, double h_b) {
  return m_a == m_b ? m_a : (h_a + h_b) / (h_a / m_a + h_b / m_b);
}

}  // namespace

RockMaterial material_of(const MechanicsParameters& parameters, const Assembly& assembly, int triangle) {
  const int region = assembly.region.empty() ? 0 : assembly.region[triangle];
  if (region == 0) return {parameters.density, parameters.thermal_expansion, parameters.bond};
  return parameters.materials[region - 1];
}

BondParameters joint_of(const BondParameters& a, double h_a, const BondParameters& b, double h_b) {
  BondParameters joint = a;
  joint.normal_modulus = in_series(a.normal_modulus, h_a, b.normal_modulus, h_b);
  joint.tangential_modulus = in_series(a.tangential_modulus, h_a, b.tangential_modulus, h_b);
  using Number = double BondParameters::*;
  for (const Number number :
       {&BondParameters::normal_strength, &BondParameters::cohesion, &BondParameters::internal_friction,
        &BondParameters::fracture_energy_I, &BondParameters::fracture_energy_II})
    joint.*number = std::min(a.*number, b.*number);
  if (a.damping != b.damping) joint.damping = (h_a * a.damping + h_b * b.damping) / (h_a + h_b);
  return joint;
}

double largest_expansion(const MechanicsParameters& parameters) {
  double largest = parameters.thermal_expansion;
  for (const RockMaterial& material : parameters.materials)
    if (std::abs(material.thermal_expansion) > std::abs(largest)) largest = material.thermal_expansion;
  return largest;
}

double mean_expansion(const MechanicsParameters& parameters, const Assembly& assembly) {
  if (assembly.region.empty()) return parameters.thermal_expansion;
  double area = 0, expansion = 0;
  for (int t = 0; t < static_cast<int>(assembly.triangles.size()); ++t) {
    const double own = triangle_of(assembly, t).area();
    area += own;
    expansion += own * material_of(parameters, assembly, t).thermal_expansion;
  }
  return expansion / area;
}

double least_normal_strength(const MechanicsParameters& parameters) {
  double least = parameters.bond.normal_strength;
  for (const RockMaterial& material : parameters.materials) least = std::min(least, material.bond.normal_strength);
  return least;
}

double sound_crossing(const MechanicsParameters& parameters, const Assembly& assembly) {
  double area = 0, slowness = 0;
  for (int t = 0; t < static_cast<int>(assembly.triangles.size()); ++t) {
    const Triangle triangle = triangle_of(assembly, t);
    const RockMaterial material = material_of(parameters, assembly, t);
    area += triangle.area();
    slowness += triangle.area() / wave_speed_of(material.bond, material.density);
  }
  const Extent rock = extent_of(assembly);
  return std::max(rock.width(), rock.height()) * slowness / area * std::sqrt(parameters.mass_scaling);
}

void require_materials(const MechanicsParameters& parameters, const Assembly& assembly) {
  if (assembly.region.empty()) return;
  if (assembly.region.size() != assembly.triangles.size())
    throw InputError("rock assembly: the region of every triangle must be given, or of none");
  for (const int region : assembly.region)
    if (region < 0 || region > static_cast<int>(parameters.materials.size()))
      throw InputError("rock assembly: region " + std::to_string(region) + " has no material");
}

}  // namespace vug
