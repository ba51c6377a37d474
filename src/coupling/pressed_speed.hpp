#pragma once
// How fast given pressures can drive fluid through pores against viscosity.
#include "coupling/mouths.hpp"

#include <string>
#include <vector>

namespace vug {

/// The fastest flow that pressures drive, and the mouths between which it would be.
struct PressedFlow {
  double speed = 0;  ///< times the viscosity, lattice units: p n^2/(8 L) in a channel of L x n cells. Infinite where no
                     ///< wall holds the fluid back; 0 where no pressure drives any
  std::string from{}, to{};  ///< keys of their tables in the case
};

/// Upper bound of the speed that the pressures of mouths drive in steady flow, as the largest over all pairs of a mouth
/// with a given pressure and one whose flow follows from the pressure. Each pair counts with the largest difference of
/// its own pressures at one time (of p - f.x with a body force f, between its nearest points), so that outlets of equal
/// pressure drive nothing between them, and with its own way: the nodes at one distance from the first mouth after the
/// other, the widest pore of width w at each distance (`width`, pore_widths), up to the second mouth. Pores in series
/// have a flow of 1/8 of the pressure over the sum of w^-3 and over the smallest w. Between sides that meet at a corner
/// and between stretches of one side the way may have no length. There it is at most w/4 of the pressure: so much flows
/// from a hole of width w in the wall of a wide space in which the pressure is 0 (half of a hole in a thin screen,
/// Hasimoto 1958); Stokes flow around a corner of radius w has 0.117 w.
PressedFlow pressed_flow(const Scene& scene, const FluidPicture& picture, const std::vector<Mouth>& mouths,
                         const std::vector<int>& width, const LatticeUnits& units);

}  // namespace vug
