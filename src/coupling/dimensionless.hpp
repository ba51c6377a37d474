#pragma once
// Dimensionless numbers of a case that are known before it runs.
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

struct DimensionlessNumber {
  std::string name;  ///< "Re", "Sc of acid", ...
  double value;
  std::string definition;  ///< as in "U L / nu"
};
/// The numbers with the length and the speed that they are formed with, as texts.
struct DimensionlessNumbers {
  std::vector<DimensionlessNumber> numbers;
  std::string scales;  ///< "L = 0.004 m, the shorter side of the lattice; ..."; empty where there are no numbers
};

/// Re, Pr, Sc, Pe, Fo and Da (Eq. 13: k_r^0 L / D), as far as the case gives what they are made of. L is
/// reaction.length, otherwise the shorter side of the lattice; U is the largest prescribed velocity or mean velocity of
/// a flow rate (pressures give none); t is the end of the run; k_r^0, nu and D are those at their reference
/// temperatures.
DimensionlessNumbers dimensionless_numbers(const Scene& scene);

}  // namespace vug
