#include "dem/soundness.hpp"

#include "base/require.hpp"
#include "dem/dissolved_rock.hpp"
#include "dem/pieces.hpp"

#include <cmath>
#include <cstdio>

namespace vug {

namespace {

/// The triangles that intact bonds still join to one of them, and how they move as a whole.
struct Piece {
  int triangles = 0;
  bool held = false;  ///< by a support
  double speed = 0;   ///< of its centre of mass, m/s
};

Piece piece_of(const Mechanics& rock, int particle) {
  const Particles& p = rock.particles();
  const std::vector<int> piece = find_pieces(p, rock.bonds());
  const auto mass = on_host(p.mass), fraction = on_host(p.solid_fraction);
  const auto held = on_host(p.held);
  const auto v = on_host(p.v);
  Piece out;
  Vec2 momentum;
  double all = 0;
  for (int i = 0; i < p.count; ++i) {
    if (piece[i] != piece[particle]) continue;
    const double own = mass(i) * mass_fraction(fraction(i));
    ++out.triangles;
    out.held = out.held || held(i) != 0;
    momentum = momentum + own * Vec2{v(i, 0), v(i, 1)};
    all += own;
  }
  out.speed = norm(momentum) / all;
  return out;
}

const char* const smaller_steps = "take more sub-steps (mechanics.substeps) or a smaller mechanics.critical_fraction";

/// Cause and advice for a particle that moves at `speed`, more than allowed. Whole pieces that are driven or thrown
/// move as one; within one that an unstable step tears at, triangles move against each other.
std::string cause_of_speed(const Mechanics& rock, int particle, double speed, bool in_fluid) {
  if (on_host(rock.particles().held)(particle) != 0)
    return "a support holds it: its platen is too fast, or what it holds turns too fast";
  const Piece piece = piece_of(rock, particle);
  if (piece.triangles > 1 && (piece.held || piece.speed < 0.5 * speed)) return smaller_steps;
  const std::string driver =
      in_fluid ? "the fluid drives it from where it is drawn on the lattice" : "loads or contacts have thrown it off";
  if (piece.triangles == rock.particles().count) return "no support holds the rock: " + driver;
  if (piece.triangles == 1) return "it is a fragment that no bond holds: " + driver;
  return "it is of a piece of " + std::to_string(piece.triangles) +
         " triangles that neither bonds nor supports hold: " + driver;
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
           cause_of_speed(rock, runaway.particle, runaway.speed, in_fluid);
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
