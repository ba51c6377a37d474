#pragma once
// Checks that the motion of the rock is still physical; called every few hundred steps.
#include "dem/mechanics.hpp"

#include <string>

namespace vug {

/// Speed above which a particle counts as diverged, m/s: nothing in rock is faster than its sound.
inline constexpr double runaway_speed = 3000;

/// One line on what is wrong: a particle whose motion is not finite or faster than `runaway_speed` (loose: a fragment;
/// bonded: an unstable step), or more contacts than the list holds; empty when nothing is wrong. Waits for the device.
std::string what_is_unsound(const Exec& exec, const Mechanics& rock);

/// Throws StabilityError with that line, if there is one.
void require_sound(const Exec& exec, const Mechanics& rock);

}  // namespace vug
