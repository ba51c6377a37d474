#pragma once
// How much heavier the triangles may be made without a noticeable effect. Sub-steps may be longer by the same factor by
// which waves are slower.
#include "io/scene.hpp"

#include <string>

namespace vug {

/// Shortest time (s) in which something that loads the rock changes: a ramp, or the points of a table, of pressures,
/// velocities and tractions; or the time that heat takes through a triangle of generated rock, h^2 / alpha. 0 where
/// anything begins with a jump, and where rock that no side supports falls; infinity where nothing changes.
double quickest_load(const Scene& scene);

/// Whether a side, or a part of one, holds the rock.
bool is_supported(const Scene& scene);

/// Whether even the fourfold mass of a preset may show: stresses or platens that change, springs, rock more than twice
/// as long as wide, rock that gravity moves and no side supports.
bool feels_its_mass(const Scene& scene);

/// Speed up to which a platen, or rock that starts with it, presses as if at rest, m/s: in compression inertia adds 5 %
/// to the strength at 1 m/s.
inline constexpr double fastest_press = 1;

/// Time in which a wave crosses the longest side in the slowest material of the rock, at mass_scaling 1:
/// L / sqrt(M_n / rho), s.
double crossing_time(const Scene& scene);

/// The largest mechanics.mass_scaling m of 1, 4, 16 and 64 (nothing heavier was measured) with which the rock still
/// follows its loads within a tolerance t: a wave, of speed sqrt(M_n / (m rho)) in the slowest of its materials,
/// crosses the longest side within 6 t times quickest_load. The 6 is from the paper's rock (docs/model.md, "Intervals
/// from a tolerance"). Rock more than twice as long as wide may bend, in a time longer by that ratio; on springs
/// (`stiffness` K) rock of length L swings in 2 pi sqrt(rho L / K): that root counts if it is longer.
double quasi_static_mass_scaling(const Scene& scene, double tolerance);

/// Says that a tolerance has chosen it, and why: for the log and `vug check`.
std::string mass_scaling_note(const Scene& scene);

}  // namespace vug
