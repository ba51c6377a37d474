#pragma once
// Where one stretch of a side ends and another begins: what velocities along the side do there (docs/model.md,
// "Velocity sides and moving walls").
#include "coupling/stretch_links.hpp"

#include <array>
#include <vector>

namespace vug {

/// Fills `ends`, `slides` and `image` of the stretches of sides, whose links have been found, on a lattice of `spacing`
/// (m). Waits for the device where a velocity along a side or two velocities at a corner are given.
void find_ends(const Exec& exec, const FluidNodes& fluid, double spacing, std::vector<StretchLinks>& boundaries);

/// Fills `past` and `ends` of pressures and outflows on sides, whose mirror links have been found: their links past an
/// end, where another stretch goes on along the side or two outflows meet at a corner. Called after find_ends. Waits
/// for the device where there are such.
void find_links_past_ends(const FluidNodes& fluid, double spacing, std::vector<StretchLinks>& boundaries);

/// Velocity on the link at an end of `boundary`, from its own velocity and that of the stretch beyond.
std::array<double, 2> velocity_at_end(const StretchLinks& boundary, const StretchEnd& end, std::array<double, 2> own,
                                      std::array<double, 2> other);

/// Volume, cells per step, that enters by the link at a corner for the stretch beyond, which is on `other` and has this
/// velocity.
double entered_for(Side other, const StretchEnd& end, std::array<double, 2> velocity);

/// Volume, cells per step, that enters by the link at end `e` (0 or 1) of `boundary`, where the fluid has this
/// velocity, only because it moves along the side: 6 w u_t, u_t towards the stretch. As much leaves by the link of the
/// stretch beyond on the same side, so that it crosses neither.
double passed_along(const StretchLinks& boundary, int e, std::array<double, 2> velocity);

}  // namespace vug
