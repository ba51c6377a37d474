#pragma once
// The sound with which the pressure of a column of fluid under its weight builds up.
#include "coupling/body_forces.hpp"
#include "coupling/mouths.hpp"

#include <vector>

namespace vug {

/// Largest speed, lattice units, of a column of height H that comes under an acceleration g at once. A run starts from
/// one pressure everywhere, so that at first nothing carries the weight; sound then runs up and down the column until
/// the pressure does. With the wave equation u_tt = c_s^2 u_zz (u_t = g at the start, u = 0 at a wall, u_z = 0 where
/// the pressure is given) d'Alembert's solution is at most
///   g H/(2 c_s)  in the middle between two walls, at the time H/(2 c_s);
///   g H/c_s      at an open end.
double weight_wave(double g, double height, bool open);

/// Upper bound, lattice units, of the speed in any piece of fluid while its weight sets in, from the height of the
/// piece along each axis. Friction keeps it below g w^2/(8 nu), with w the width of the widest pore of the piece,
/// unless a given pressure other than that of the start sends sound of its own. Where fluid has a way along an axis and
/// no pressure is to carry it, the weight drives it instead (force_speed.hpp): 0. `width` and `piece` are those of each
/// node (shorter_widths, pieces_of).
double weight_wave_speed(const Scene& scene, const BodyForces& forces, const FluidPicture& picture,
                         const std::vector<double>& width, const std::vector<Mouth>& mouths,
                         const std::vector<int>& piece, const LatticeUnits& units);

}  // namespace vug
