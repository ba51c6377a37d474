#include "dem/soundness.hpp"

#include "kernels/base/require.hpp"

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

}  // namespace

std::string what_is_unsound(const Exec& exec, const Mechanics& rock) {
  const RunawayParticle runaway = rock.runaway(exec, runaway_speed);
  if (runaway.particle >= 0) {
    char speed[32];
    std::snprintf(speed, sizeof speed, "%.3g", runaway.speed);
    return "particle " + std::to_string(runaway.particle) + " moves at " + speed + " m/s; " +
           (is_loose(rock.bonds(), runaway.particle)
                ? "no bond holds it: a fragment that the fluid drives from where it is drawn on the lattice has left "
                  "the model"
                : "take more sub-steps (mechanics.substeps) or a smaller mechanics.critical_fraction");
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
