#pragma once
// Forces of pairs of triangles that touch without being bonded.
#include "dem/accounts.hpp"
#include "dem/bond_kinematics.hpp"
#include "dem/closest_point.hpp"
#include "dem/contact_law.hpp"
#include "dem/contacts.hpp"

namespace vug {

// Used by forces.cpp only. With external names less of this would be inlined, which costs time and changes last bits.
namespace {

/// Eroded outline of a particle, scaled down by dissolution, relative to a reference point, and its motion.
struct MovingOutline {
  Triangle outline;
  Vec2 centre;  ///< of the particle, relative to the same point
  Vec2 v;
  double spin = 0;
};

/// Energy that the pairs of a particle store in their springs and have lost to friction in this step.
struct PairEnergy {
  double stored = 0, friction = 0;
};

/// Load of a pair's contacts on its two particles a and b: the force on a; the force on b is the opposite.
struct PairLoad {
  Vec2 force;
  double torque_a = 0, torque_b = 0;

  KOKKOS_FORCEINLINE_FUNCTION void add(Vec2 f, Vec2 arm_a, Vec2 arm_b) {
    force = force + f;
    torque_a += cross(arm_a, f);
    torque_b -= cross(arm_b, f);
  }
};

/// What a contact of a pair keeps from step to step: references into Contacts.
struct ContactState {
  double& stretch;
  double& idle_overlap;
};

/// Sum of both kinds of contacts of a pair; in `other` the roles of the two particles are exchanged.
KOKKOS_FORCEINLINE_FUNCTION PairLoad difference(const PairLoad& load, const PairLoad& other) {
  return {load.force - other.force, load.torque_a + other.torque_b, load.torque_b + other.torque_a};
}

/// Contacts of a pair: corners of each particle with the outline of the other. n points from the outline's body to the
/// corner's body. Springs, dashpots and Coulomb friction K_n, K_t, c_n, mu of Table 1 act at the contact point half way
/// between them, the normal spring on what the overlap 2 R - distance exceeds Contacts::idle_overlap. Every corner has
/// its own closest point, which may be inside an edge or a corner. Distances are therefore continuous, and so are
/// forces and energy, however the two slide round each other. Two corners that meet count twice, once for each. Forces
/// cancel exactly and act on one line.
template <class Keeper>
struct ContactForces {
  ContactParameters law;
  double expansion;
  double dt;
  Particles particles;
  Contacts contacts;
  Keeper accounts;

  KOKKOS_FUNCTION MovingOutline body(int i, Vec2 origin) const {
    const EndMotion m = motion_of(particles, expansion, i);
    MovingOutline out;
    out.centre = Vec2{particles.x0(i, 0), particles.x0(i, 1)} - origin + m.u;
    out.v = m.v;
    out.spin = m.spin;
    const double scale = m.scale * outline_scale(particles.solid_fraction(i));
    for (int c = 0; c < 3; ++c) {
      const Vec2 r{particles.eroded(i, c, 0), particles.eroded(i, c, 1)};
      out.outline.corner[c] = out.centre + scale * m.rotation.turn(r);
    }
    return out;
  }

  /// Adds the load on corner c of `a` at the point `where` of the outline of b: the whole load, and the part of the
  /// dashpots.
  KOKKOS_FUNCTION void add_corner(const MovingOutline& a, const MovingOutline& b, int c, const ClosestPoint& where,
                                  double overlap, double& stretch, PairLoad& load, PairLoad& drag,
                                  PairEnergy& energy) const {
    const Vec2 n = where.normal, t{-n.y, n.x};
    const Vec2 at = a.outline.corner[c] - (0.5 * where.distance) * n, arm_a = at - a.centre, arm_b = at - b.centre;
    const Vec2 rate = a.v + spin_times(a.spin, arm_a) - b.v - spin_times(b.spin, arm_b);
    const ContactPoint point{law.normal_stiffness, law.tangential_stiffness, law.normal_damping, law.tangential_damping,
                             law.friction};
    const double rate_t = dot(rate, t), before = stretch, offset = before + dt * rate_t;
    const ContactReaction reaction = contact_reaction(point, overlap, -dot(rate, n), offset, rate_t, 0);
    stretch = offset - reaction.slip;
    load.add(reaction.normal * n + reaction.tangential * t, arm_a, arm_b);
    // in the leapfrog's form (accounts.hpp): the next overlap and stretch follow from the present rates
    energy.stored += 0.5 * (law.normal_stiffness * overlap * (overlap - dt * dot(rate, n)) +
                            law.tangential_stiffness * stretch * (stretch + dt * rate_t));
    if constexpr (Keeper::kept) {
      energy.friction += 0.5 * law.tangential_stiffness * (before + stretch) * reaction.slip;
      drag.add((reaction.normal - law.normal_stiffness * overlap) * n +
                   (reaction.tangential + law.tangential_stiffness * stretch) * t,
               arm_a, arm_b);
    }
  }

  /// Writes the load of a pair and the part of its dashpots.
  KOKKOS_FUNCTION void leave(int pair, const PairLoad& load, const PairLoad& drag) const {
    contacts.load(pair, 0) = load.force.x;
    contacts.load(pair, 1) = load.force.y;
    contacts.load(pair, 2) = load.torque_a;
    contacts.load(pair, 3) = load.torque_b;
    accounts.keep_pair_drag(pair, drag.force.x, drag.force.y, drag.torque_a, drag.torque_b);
  }

  KOKKOS_FUNCTION ContactState state(int pair, int generation, int feature) const {
    return {contacts.stretch(pair, generation, feature), contacts.idle_overlap(pair, generation, feature)};
  }

  /// Releases the friction spring of a corner that does not push; its energy counts as friction.
  KOKKOS_FUNCTION void release(double& stretch, PairEnergy& energy) const {
    energy.friction += 0.5 * law.tangential_stiffness * stretch * stretch;
    stretch = 0;
  }

  KOKKOS_FUNCTION void push_corner(const MovingOutline& a, const MovingOutline& b, int c, const ContactState& kept,
                                   PairLoad& load, PairLoad& drag, PairEnergy& energy) const {
    const ClosestPoint where = closest_on_triangle(b.outline, a.outline.corner[c]);
    const double overlap = 2 * particles.radius - where.distance;
    if (!(overlap > 0))
      kept.idle_overlap = 0;
    else if (kept.idle_overlap == before_first_look)
      kept.idle_overlap = overlap;
    if (overlap > kept.idle_overlap)
      add_corner(a, b, c, where, overlap - kept.idle_overlap, kept.stretch, load, drag, energy);
    else
      release(kept.stretch, energy);
  }

  KOKKOS_FUNCTION void push_pair(int low, const MovingOutline& a, Vec2 origin, int pair, int generation,
                                 PairEnergy& energy) const {
    const int high = contacts.other(pair, generation);
    const MovingOutline b = body(high, origin);
    const double gap = 2 * particles.radius * (1 + 1e-9);  // beyond rounding
    if (is_gone(particles.solid_fraction(low)) || is_gone(particles.solid_fraction(high)) ||
        keeps_clear(a.outline, b.outline, gap) || keeps_clear(b.outline, a.outline, gap)) {
      for (int f = 0; f < pair_features; ++f) {
        release(contacts.stretch(pair, generation, f), energy);
        contacts.idle_overlap(pair, generation, f) = 0;
      }
      leave(pair, {}, {});
      return;
    }
    PairLoad by_a, by_b, drag_a, drag_b;  // of the corners of a on b, and of b on a, where the roles are exchanged
    for (int c = 0; c < 3; ++c) {
      push_corner(a, b, c, state(pair, generation, c), by_a, drag_a, energy);
      push_corner(b, a, c, state(pair, generation, 3 + c), by_b, drag_b, energy);
    }
    leave(pair, difference(by_a, by_b), difference(drag_a, drag_b));
  }

  /// Computes the pairs [first, last), whose lower particle is `low`.
  KOKKOS_FUNCTION void push_pairs(int low, int first, int last, int generation) const {
    PairEnergy energy;
    const Vec2 origin{particles.x0(low, 0), particles.x0(low, 1)};
    const MovingOutline a = body(low, origin);
    for (int pair = first; pair < last; ++pair) push_pair(low, a, origin, pair, generation, energy);
    contacts.energy(low) = energy.stored;
    accounts.add_pair_friction(low, energy.friction);
  }

  /// Computes all pairs of a particle. Most particles have none, and no pair is listed while contacts are inactive.
  /// (Bonds::events would show this earlier, but bonds write it in the same launch.)
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int low) const {
    const int generation = contacts.status(contacts_generation);
    const int first = contacts.first(low, generation), last = contacts.first(low + 1, generation);
    if (first < last) push_pairs(low, first, last, generation);
  }
};

}  // namespace

}  // namespace vug
