#pragma once
// What a press says of the tension in a disc that it splits.
#include <cmath>

namespace vug {

/// Tension across the load at the centre of an elastic disc of diameter D over 2 F/(pi D), that of two opposite point
/// loads F: the load is a pressure p, uniform and radial, on two arcs of half angle a (Hondros 1959, Aust. J. Appl.
/// Sci. 10, 243): sigma = (2 p/pi) (sin 2a - a), and what p presses along the load is F = p D sin a. 0.964 where the
/// arcs are of 20 degrees, as Wang et al. (2004, Int. J. Rock Mech. Min. Sci. 41, 245) have of flattened discs.
inline double splitting_share(double half_angle) {
  if (half_angle == 0) return 1;
  return (std::sin(2 * half_angle) - half_angle) / std::sin(half_angle);
}

}  // namespace vug
