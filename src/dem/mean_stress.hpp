#pragma once
// Stress of a part of the rock from the forces in its bonds.
#include "dem/bonds.hpp"

#include <vector>

namespace vug {

/// Components of the Cauchy stress, tension positive, Pa.
struct Stress {
  double xx = 0, xy = 0, yy = 0;
};

/// Mean stress of the named particles, (1/A) sum of arm (x) force over the edges of each (Weber's formula, arms to the
/// middles of the edges): exact for the sum over a region whose edges are all bonded, where what the two integration
/// points of an inner edge add cancels. Contacts of broken bonds count, those of other pairs do not. Host only.
Stress mean_stress(const Particles& particles, const Bonds& bonds, const std::vector<int>& members);

}  // namespace vug
