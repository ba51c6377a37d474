#pragma once
// Strengths that vary from bond to bond: Weibull numbers that depend on names, never on the order in which they are
// drawn.
#include "base/splitmix64.hpp"

#include <cmath>
#include <cstdint>

namespace vug {

/// Properties that are drawn; each property of a bond has its own independent number.
enum class BondProperty : std::uint64_t { normal_strength = 1, cohesion = 2, energy_I = 3, energy_II = 4 };

/// A number in (0, 1) from a seed, the two vertex names of an edge (low, high) and a property.
constexpr double uniform_of(std::uint64_t seed, std::uint64_t low, std::uint64_t high, std::uint64_t property) {
  const std::uint64_t bits = splitmix64(splitmix64(splitmix64(splitmix64(seed) ^ low) ^ high) ^ property);
  return (static_cast<double>(bits >> 11) + 0.5) * 0x1.0p-53;
}

/// Quantile u of the Weibull distribution of shape m scaled to mean 1: (-ln(1 - u))^(1/m) / Gamma(1 + 1/m).
/// m = 0 stands for no scatter.
inline double weibull_of_mean_one(double u, double m) {
  if (m == 0) return 1;
  return std::pow(-std::log1p(-u), 1 / m) / std::tgamma(1 + 1 / m);
}

}  // namespace vug
