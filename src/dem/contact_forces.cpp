#include "dem/contact_forces.hpp"

#include "dem/bond_kinematics.hpp"
#include "dem/closest_point.hpp"
#include "dem/contact_law.hpp"
#include "kernels/launch.hpp"

namespace vug {

namespace {

/// The eroded outline of a particle, relative to a point, and its motion.
struct Body {
  Triangle outline;
  Vec2 centre;  ///< of the particle, relative to the same point
  Vec2 v;
  double spin = 0;
};

/// What a pair's springs hold and what it has lost in this step.
struct PairEnergy {
  double stored = 0, friction = 0, damping = 0;
};

/// One pair: corners of each against the outline of the other. n points from the outline's body to the corner's one;
/// overlap = 2 R - distance; springs, dashpots and Coulomb friction K_n, K_t, c_n, mu of Table 1 at the contact point
/// half-way. A corner whose closest point is a corner counts only if the two are each other's closest, and once: the
/// force is continuous when a corner slides round another. Forces cancel exactly and act on one line.
template <class Keeper>
struct ContactForces {
  ContactParameters law;
  double expansion;
  double dt;
  Particles particles;
  Bonds bonds;
  Contacts contacts;
  Keeper accounts;

  KOKKOS_FUNCTION Body body(int i, Vec2 origin) const {
    const EndMotion m = motion_of(particles, expansion, i);
    Body out;
    out.centre = Vec2{particles.x0(i, 0), particles.x0(i, 1)} - origin + m.u;
    out.v = m.v;
    out.spin = m.spin;
    for (int c = 0; c < 3; ++c) {
      const Vec2 r{particles.eroded(i, c, 0), particles.eroded(i, c, 1)};
      out.outline.corner[c] = out.centre + m.scale * m.rotation.turn(r);
    }
    return out;
  }

  /// Adds what corner c of `a` feels at `where` on the outline of b: forces and torques on a and b.
  KOKKOS_FUNCTION void add_corner(const Body& a, const Body& b, int c, const ClosestPoint& where, double& stretch,
                                  Vec2& force_on_a, double& torque_a, double& torque_b, PairEnergy& energy) const {
    const Vec2 n = where.normal, t{-n.y, n.x};
    const Vec2 at = a.outline.corner[c] - (0.5 * where.distance) * n;
    const Vec2 rate = a.v + spin_times(a.spin, at - a.centre) - b.v - spin_times(b.spin, at - b.centre);
    const ContactPoint point{law.normal_stiffness, law.tangential_stiffness, law.normal_damping, law.tangential_damping,
                             law.friction};
    const double offset = stretch + dt * dot(rate, t);
    const ContactReaction reaction =
        contact_reaction(point, 2 * particles.radius - where.distance, -dot(rate, n), offset, dot(rate, t), 0);
    stretch = offset - reaction.slip;
    const double overlap = 2 * particles.radius - where.distance;
    energy.stored += 0.5 * (law.normal_stiffness * overlap * overlap + law.tangential_stiffness * stretch * stretch);
    energy.friction += Kokkos::abs(reaction.tangential * reaction.slip);
    energy.damping -= dt * (reaction.normal - law.normal_stiffness * overlap) * dot(rate, n);
    const Vec2 f = reaction.normal * n + reaction.tangential * t;
    force_on_a = force_on_a + f;
    torque_a += cross(at - a.centre, f);
    torque_b -= cross(at - b.centre, f);
  }

  /// A pair that does not touch forgets its friction.
  KOKKOS_FUNCTION void release(int pair, int generation, PairEnergy& energy) const {
    for (int f = 0; f < pair_features; ++f) {
      double& stretch = contacts.stretch(pair, generation, f);
      energy.friction += 0.5 * law.tangential_stiffness * stretch * stretch;
      stretch = 0;
    }
    for (int k = 0; k < 4; ++k) contacts.load(pair, k) = 0;
  }

  KOKKOS_FUNCTION void push_pair(const Body& a, Vec2 origin, int pair, int generation, PairEnergy& energy) const {
    const Body b = body(contacts.other(pair, generation), origin);
    const double gap = 2 * particles.radius * (1 + 1e-9);  // beyond rounding
    if (keeps_clear(a.outline, b.outline, gap) || keeps_clear(b.outline, a.outline, gap)) {
      release(pair, generation, energy);
      return;
    }
    ClosestPoint of_a[3], of_b[3];
    for (int c = 0; c < 3; ++c) {
      of_a[c] = closest_on_triangle(b.outline, a.outline.corner[c]);
      of_b[c] = closest_on_triangle(a.outline, b.outline.corner[c]);
    }
    Vec2 on_a, on_b;
    double torque_a = 0, torque_b = 0;
    for (int c = 0; c < 3; ++c) {
      const bool counts = of_a[c].corner < 0 || of_b[of_a[c].corner].corner == c;
      double& stretch = contacts.stretch(pair, generation, c);
      if (counts && of_a[c].distance < 2 * particles.radius) {
        add_corner(a, b, c, of_a[c], stretch, on_a, torque_a, torque_b, energy);
      } else {
        energy.friction += 0.5 * law.tangential_stiffness * stretch * stretch;
        stretch = 0;
      }
    }
    for (int c = 0; c < 3; ++c) {
      double& stretch = contacts.stretch(pair, generation, 3 + c);
      if (of_b[c].corner < 0 && of_b[c].distance < 2 * particles.radius) {
        add_corner(b, a, c, of_b[c], stretch, on_b, torque_b, torque_a, energy);
      } else {
        energy.friction += 0.5 * law.tangential_stiffness * stretch * stretch;
        stretch = 0;
      }
    }
    contacts.load(pair, 0) = on_a.x - on_b.x;
    contacts.load(pair, 1) = on_a.y - on_b.y;
    contacts.load(pair, 2) = torque_a;
    contacts.load(pair, 3) = torque_b;
  }

  /// All pairs of which particle `low` is the lower one.
  KOKKOS_FUNCTION void operator()(int low) const {
    if (bonds.events(bond_has_failed) == 0) return;
    const int generation = contacts.status(contacts_generation);
    PairEnergy energy;
    const int first = contacts.first(low, generation), last = contacts.first(low + 1, generation);
    if (first < last) {
      const Vec2 origin{particles.x0(low, 0), particles.x0(low, 1)};
      const Body a = body(low, origin);
      for (int pair = first; pair < last; ++pair) push_pair(a, origin, pair, generation, energy);
    }
    contacts.energy(low) = energy.stored;
    accounts.add_pair(low, energy.friction, energy.damping);
  }
};

/// Sum of a particle's contacts, in the order of its row.
struct GatherContacts {
  Bonds bonds;
  Contacts contacts;
  KOKKOS_FUNCTION void operator()(int i) const {
    if (bonds.events(bond_has_failed) == 0) return;
    double x = 0, y = 0, torque = 0;
    for (int e = contacts.row(i); e < contacts.row(i + 1); ++e) {
      const int k = contacts.entry(e) / 2, end = contacts.entry(e) % 2;
      const double sign = end == 0 ? 1 : -1;
      x += sign * contacts.load(k, 0);
      y += sign * contacts.load(k, 1);
      torque += contacts.load(k, 2 + end);
    }
    contacts.push(i, 0) = x;
    contacts.push(i, 1) = y;
    contacts.push(i, 2) = torque;
  }
};

}  // namespace

template <class Keeper>
void compute_contact_forces(const Exec& exec, const MechanicsParameters& parameters, double dt,
                            const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                            const Keeper& accounts) {
  for_each_node(exec, "vug::dem::contact_forces", particles.count,
                ContactForces<Keeper>{parameters.contact, parameters.thermal_expansion, dt, particles, bonds, contacts,
                                      accounts});
  for_each_node(exec, "vug::dem::gather_contacts", particles.count, GatherContacts{bonds, contacts});
}

template void compute_contact_forces(const Exec&, const MechanicsParameters&, double, const Particles&, const Bonds&,
                                     const Contacts&, const NoAccounts&);
template void compute_contact_forces(const Exec&, const MechanicsParameters&, double, const Particles&, const Bonds&,
                                     const Contacts&, const Accounts&);

}  // namespace vug
