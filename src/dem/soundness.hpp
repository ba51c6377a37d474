#pragma once
// Whether the rock still moves as rock can: asked by whoever runs it, every few hundred steps.
#include "dem/mechanics.hpp"

#include <string>

namespace vug {

/// Nothing in rock outruns its own sound, m/s.
inline constexpr double runaway_speed = 3000;

/// One line on what is wrong: a particle that is not finite or faster than `runaway_speed` (a loose one is a fragment,
/// a bonded one an unstable step), or more contacts than the list holds; empty when nothing is. Waits for the device.
std::string what_is_unsound(const Exec& exec, const Mechanics& rock);

/// Throws StabilityError with that line.
void require_sound(const Exec& exec, const Mechanics& rock);

}  // namespace vug
