#pragma once
// Steps of a laboratory test: no rock sleeps in it, and it may take any number of steps.
#include "base/require.hpp"
#include "dem/mechanics.hpp"
#include "host/interruption.hpp"

#include <algorithm>
#include <string>

namespace vug {

/// Switches sleeping off: sleeping rock would not notice that a platen begins to move, and rock that is loaded slowly
/// would break later.
inline MechanicsParameters without_rest(MechanicsParameters parameters) {
  parameters.rest_tolerance = 0;
  return parameters;
}

/// Largest number of steps of a test: up to it a double counts them one by one. So many would take a thousand years.
inline constexpr double most_steps_of_test = 9007199254740992.0;  // 2^53

/// A number of steps, rounded down, at least one. Throws InputError, which begins with `where`, if it is more than
/// `most_steps_of_test`.
inline long whole_steps(double steps, const std::string& where) {
  if (!(steps <= most_steps_of_test))
    throw InputError(where + ": the test needs more than 9e15 steps; make it faster or shorter");
  return std::max(1L, static_cast<long>(steps));
}

/// Does the same, to the bit, as rock.advance of that many steps, but regularly checks whether the program was asked to
/// stop. Throws Interrupted.
inline void advance_long(const Exec& exec, Mechanics& rock, double dt, long steps) {
  constexpr long piece = 250;
  const double end = rock.time() + dt * static_cast<double>(steps);
  for (long taken = 0; taken < steps; taken += piece) {
    throw_if_stop_requested();
    rock.advance(exec, dt, static_cast<int>(std::min(piece, steps - taken)));
  }
  rock.set_time(end);
}

}  // namespace vug
