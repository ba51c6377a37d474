#include "dem/soundness.hpp"

#include "base/require.hpp"

#include <cmath>
#include <cstdio>

namespace vug {

namespace {

/// Whether no bond holds the particle any more.
bool is_loose(const Bonds& bonds, int particle) {
  const auto pair = on_host(bonds.pair);
  const auto state = on_host(bonds.state);
  for (int k = 0; k < bonds.count; ++k)
    if ((pair(k, 0) == particle || pair(k, 1) == particle) && !has_failed(state(k))) return false;
  return true;
}

const char* const smaller_steps = "take more sub-steps (mechanics.substeps) or a smaller mechanics.critical_fraction";

/// Cause and advice for a particle that is faster than allowed.
std::string cause_of_speed(const Mechanics& rock, int particle, bool in_fluid) {
  if (on_host(rock.particles().held)(particle) != 0)
    return "a support holds it: its platen is too fast, or what it holds turns too fast";
  if (!is_loose(rock.bonds(), particle)) return smaller_steps;
  return in_fluid ? "no bond holds it: a fragment that the fluid drives from where it is drawn on the lattice has left "
                    "the model"
                  : "no bond holds it: a fragment that loads or contacts have thrown off has left the model";
}

}  // namespace

std::string what_is_unsound(const Exec& exec, const Mechanics& rock, bool in_fluid) {
  const RunawayParticle runaway = rock.runaway(exec, runaway_speed);
  if (runaway.particle >= 0 && !std::isfinite(runaway.speed))
    return "the motion of particle " + std::to_string(runaway.particle) +
           " is not a finite number: a load is out of all bounds, or the step too long; " + smaller_steps;
  if (runaway.particle >= 0) {
    char speed[32];
    std::snprintf(speed, sizeof speed, "%.3g", runaway.speed);
    return "particle " + std::to_string(runaway.particle) + " moves at " + speed + " m/s (with its turning); " +
           cause_of_speed(rock, runaway.particle, in_fluid);
  }
  int lost = 0;
  Kokkos::deep_copy(lost, Kokkos::subview(rock.contacts().status, contacts_lost));
  if (lost == 0) return {};
  return "the rock has gone to pieces, " + std::to_string(lost) +
         " pairs of touching triangles are more than the contact list holds";
}

void require_sound(const Exec& exec, const Mechanics& rock) {
  const std::string wrong = what_is_unsound(exec, rock);
  if (!wrong.empty()) throw StabilityError("mechanics diverged: " + wrong);
}

}  // namespace vug
