#pragma once
// What a case does to the sides of the rock, as its mechanics wants to be told.
#include "dem/loads.hpp"
#include "io/scene.hpp"

#include <string_view>

namespace vug {

/// "left", "right", "bottom" or "top".
RockSide rock_side(std::string_view name);

/// Outer stress and supports of the four sides and their parts, and gravity. A side whose loads change in time, or
/// whose platen moves, is a part as long as the side.
Loads boundary_loads(const Scene& scene);

/// The largest stress (Pa) that a case is known to put on its rock at any time: tractions, pressures above or below the
/// initial one, held-back expansion M_n alpha dT, weight over the longest side of rock and driven fluid, the waves of
/// initial velocities. 0 where it names none; what a given flow needs of pressure is not known.
double largest_load(const Scene& scene);

}  // namespace vug
