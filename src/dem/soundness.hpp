#pragma once
// Checks that the motion of the rock is still physical; called every few hundred steps.
#include "dem/mechanics.hpp"
#include "dem/runaway_speed.hpp"

#include <string>

namespace vug {

/// One line on what is wrong: a particle whose motion is not finite or faster than `runaway_speed` (held: its platen;
/// of a loose piece that moves as one: what drives it, fluid where there is any; otherwise an unstable step), or more
/// contacts than the list holds; empty when nothing is wrong. Waits for the device.
std::string what_is_unsound(const Exec& exec, const Mechanics& rock, bool in_fluid = false);

/// Throws StabilityError with that line, if there is one.
void require_sound(const Exec& exec, const Mechanics& rock);

}  // namespace vug
