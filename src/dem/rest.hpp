#pragma once
// Rock that rests: neighbouring triangles in groups, which sleep while what pushes them is too little to matter.
#include "dem/integrate.hpp"

namespace vug {

inline constexpr int particles_per_group = 64;
/// What a processor does at once. A checkpoint has a switch per group: one of a processor goes on on a GPU and back.
inline constexpr int bonds_per_group = 8;

/// Groups of particles, and of bonds.
///
/// The unrest of a particle is the largest of the forces that would move it along an axis it is free to move along, of
/// the forces that would stop it within a sub-step, and of the same torques over its radius of gyration. A group wakes
/// when the unrest of one of its particles, or the sum of the forces on all of them, passes `tolerance` times the
/// largest force of its bonds, which counts as `least` at least and as `strength` at most; it sleeps,
/// without its velocities, below a quarter of that. The sum keeps what many particles lack together from adding up.
/// Bonds are asleep with both of their ends: nothing of them is read.
struct Rest {
  double tolerance = 0;
  double strength = 0;  ///< of a bond of mean strength and mean length, N
  double least = 0;     ///< a tenth of that, or what the largest load puts on such a bond where that is less, N
  Groups particles;
  Groups bonds;
  /// Bonds that a look needs anew: of those that sleep what fell asleep at the last one, with velocities then.
  Groups due;
  bool all_due = true;  ///< all of them at the next look: the rock has changed
  /// Groups of particles at the last look; a run that is resumed takes all for awake until the next, a GPU always: the
  /// host would have to wait for the number, and where nothing runs kernels end at once.
  int awake = 0;
};

/// All awake; `normal_strength` is the bonds' mean, `largest_load` the largest stress that loads them, Pa (0: unknown).
Rest make_rest(const Particles& particles, const Bonds& bonds, double normal_strength, double largest_load,
               double tolerance);

/// Share of the groups of particles that are awake; for the history, not inside a step.
double awake_share(const Rest& rest);

/// Finds out which of our groups of particles rest, from bond forces and contact forces of now; gathers the latter, and
/// leaves what holds the particles in their `reaction`.
void look_at_rest(const Exec& exec, const StepControl& control, const Bonds& bonds, const Contacts& contacts,
                  const BoundaryLoads& loads, const Particles& particles, const Rest& rest);

/// Bonds run when one of their ends may move, and are due then and once more; counts what is awake.
void wake_bonds(const Exec& exec, const Bonds& bonds, Rest& rest);

}  // namespace vug
