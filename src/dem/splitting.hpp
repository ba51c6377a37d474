#pragma once
// Tension in a disc that a press splits.
#include <cmath>

namespace vug {

/// Tension across the load at the centre of an elastic disc of diameter D over 2 F/(pi D), which is that of two
/// opposite point loads F. The load is a pressure p, uniform and radial, on two arcs of half angle a (Hondros 1959,
/// Aust. J. Appl. Sci. 10, 243): sigma = (2 p/pi) (sin 2a - a); its force along the load is F = p D sin a. The result
/// is 0.964 for arcs of 20 degrees, as Wang et al. (2004, Int. J. Rock Mech. Min. Sci. 41, 245) have for flattened
/// discs.
inline double splitting_share(double half_angle) {
  if (half_angle == 0) return 1;
  return (std::sin(2 * half_angle) - half_angle) / std::sin(half_angle);
}

}  // namespace vug
