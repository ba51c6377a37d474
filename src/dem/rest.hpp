#pragma once
// Rock that rests: groups of neighbouring triangles sleep while the forces on them are too small to matter.
#include "dem/integrate.hpp"

namespace vug {

inline constexpr int particles_per_group = 64;
/// What a processor evaluates at once. Kept on a GPU as well: a checkpoint stores a switch per group, and a run may
/// move between processor and GPU.
inline constexpr int bonds_per_group = 8;

/// Groups of particles and of bonds, and which of them are awake.
///
/// The unrest of a particle is the largest of: the forces that would move it along the axes on which it is free, the
/// forces that would stop it within a sub-step, and the corresponding torques over its radius of gyration. A group
/// wakes when the unrest of one of its particles, or the sum of the forces on all of them, exceeds `tolerance` times
/// the largest force of its bonds, limited to the range from `least` to `most`. It falls asleep below a quarter of
/// that; its velocities are then set to zero. The sum prevents small imbalances of many particles from adding up. A
/// bond sleeps while both of its ends do: nothing of it is read.
struct Rest {
  double tolerance = 0;
  /// Force on a bond of mean length: what breaks it, in the weakest material, or what the largest change of load makes
  /// where that is less, N. Rock under a constant stress would otherwise sleep through a small load that comes on top.
  double most = 0;
  /// A tenth of what breaks it, or what that change makes where that is less, N; of loads that do not change, or whose
  /// change is unknown, what the largest one makes.
  double least = 0;
  Groups particles;
  Groups bonds;
  /// Bonds to be evaluated for the next check: those that are awake, and those that fell asleep at the last one,
  /// because their forces were computed with velocities that are zero now.
  Groups due;
  bool all_due = true;  ///< evaluate all bonds for the next check: the rock has changed
  /// Number of groups of particles awake at the last check. A resumed run takes all as awake until its first check. On
  /// a GPU all always count: the host would have to wait for the number, and kernels of sleeping groups end at once.
  int awake = 0;
};

/// Makes groups that are all awake. `normal_strength`: mean of the bonds of the weakest material, Pa; `loads`: their
/// `largest` and `change`.
Rest make_rest(const Particles& particles, const Bonds& bonds, double normal_strength, const Loads& loads,
               double tolerance);

/// Share of the groups of particles that are awake; for the history, not for use inside a step.
double awake_share(const Rest& rest);

/// Determines which of this rank's groups of particles rest, from the present forces of bonds and contacts. Gathers the
/// contact forces, and stores the forces that hold particles in their `reaction`.
void look_at_rest(const Exec& exec, const StepControl& control, const Bonds& bonds, const Contacts& contacts,
                  const BoundaryLoads& loads, const Particles& particles, const Rest& rest);

/// Wakes the bonds of which one end is awake and lets the others sleep; due are those awake now or before. On a host
/// also counts the groups of particles that are awake.
void wake_bonds(const Exec& exec, const Bonds& bonds, Rest& rest);

}  // namespace vug
