#pragma once
// Another reading of the paper's Table 1.
#include "dem/parameters.hpp"

#include <cmath>

namespace vug {

/// Table 1 in the reading that gives the paper's measured strength without a fit:
/// - the printed strengths and energies are scale parameters of their Weibull distributions of shape
///   p.bond.weibull_shape (mean = scale Gamma(1 + 1/m), 6.5 % less for m = 7; the scale itself for m = 0, no scatter);
/// - f1 and f2 act as printed (0.98 and 1.01 in fresh rock);
/// - the internal friction is no part of a bond's strength.
inline MechanicsParameters weibull_scale_reading(MechanicsParameters p) {
  const double shape = p.bond.weibull_shape;
  const double mean_over_scale = shape > 0 ? std::tgamma(1 + 1 / shape) : 1;
  p.bond.normal_strength *= mean_over_scale;
  p.bond.cohesion *= mean_over_scale;
  p.bond.fracture_energy_I *= mean_over_scale;
  p.bond.fracture_energy_II *= mean_over_scale;
  p.bond.internal_friction = 0;
  p.chemical.normalised = false;
  return p;
}

}  // namespace vug
