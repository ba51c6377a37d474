#include "dem/integrate.hpp"

#include "dem/gather_contacts.hpp"
#include "dem/launch_in_turn.hpp"
#include "dem/push.hpp"

namespace vug {

namespace {

/// Moves one particle. Local damping is F -= alpha |F| sign(v). Held axes follow their platen, and the force that holds
/// them is stored in `reaction`. Rock that is gone stays where it is. There are no branches and no calls, so that a
/// host moves eight particles at once. Reads about 45 numbers, writes 11. Conserves momentum up to the sum of the
/// outside forces.
template <class Keeper>
struct Integrate {
  StepControl control;
  ParticlePush push;
  Keeper accounts;

  /// New velocity of one degree of freedom under `force`, local damping included.
  KOKKOS_FORCEINLINE_FUNCTION double kicked(double v, double force, double inverse_mass) const {
    const double against = v > 0 ? -1 : v < 0 ? 1 : 0;
    return v + control.dt * inverse_mass * (force + control.local_damping * Kokkos::abs(force) * against);
  }

  /// Energy that local damping takes when the velocity changes from v to w.
  KOKKOS_FORCEINLINE_FUNCTION double damped(double v, double w, double force) const {
    const double along = v > 0 ? 1 : v < 0 ? -1 : 0;
    return control.dt * control.local_damping * Kokkos::abs(force) * along * 0.5 * (v + w);
  }

  /// Energy that the dashpots of its contacts take from one degree of freedom.
  KOKKOS_FORCEINLINE_FUNCTION double dragged(int i, int component, double v, double w) const {
    return -control.dt * accounts.particle_drag(i, component) * 0.5 * (v + w);
  }

  /// Moves one degree of freedom of a particle that is present (`here` = 1) or gone (0). The work of the `given` forces
  /// and of the platen, and damping, go to the accounts.
  KOKKOS_FORCEINLINE_FUNCTION void move(int i, int axis, double here, double force, double given,
                                        double inverse_mass) const {
    const bool held = (push.p.held(i) & (axis == 0 ? 1 : 2)) != 0;
    // `drive` is read for all: a read under a condition would keep the loop from being vectorised
    const double v = push.p.v(i, axis), drive = push.p.drive(i, axis), kick = kicked(v, force, inverse_mass);
    const double w = here * (held ? drive : kick);
    push.p.v(i, axis) = w;
    push.p.u(i, axis) += control.dt * w;
    push.p.reaction(i, axis) = held ? -force : 0.0;
    if constexpr (Keeper::kept) {
      const double jerk = 0.5 * (w * w - v * v) / inverse_mass;  // of a platen that changes its speed
      accounts.add_particle(
          i, held ? control.dt * (given - force) * 0.5 * (v + w) + jerk : control.dt * given * 0.5 * (v + w),
          (held ? 0 : damped(v, w, force)) + dragged(i, axis, v, w));
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION void turn(int i, double here, double torque, double given, double inverse_inertia) const {
    const bool held = (push.p.held(i) & 4) != 0;
    const double v = push.p.spin(i), kick = kicked(v, torque, inverse_inertia);
    const double w = here * (held ? 0.0 : kick);
    const double angle = push.p.angle(i) + control.dt * w;
    const Rotation rotation = Rotation::by(angle);
    push.p.spin(i) = w;
    push.p.angle(i) = angle;
    push.p.rotation(i, 0) = rotation.cos_minus_1;
    push.p.rotation(i, 1) = rotation.sin;
    if constexpr (Keeper::kept) {
      accounts.add_particle(i, held ? 0 : control.dt * given * 0.5 * (v + w),
                            (held ? 0 : damped(v, w, torque)) + dragged(i, 2, v, w));
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    const Push given = push.outside(i), all = push.total(i, given);
    const double left = push.p.solid_fraction(i), here = presence(left);
    const double share = control.mass_scaling * mass_fraction(left);
    const double inverse_mass = 1 / (share * push.p.mass(i)), inverse_inertia = 1 / (share * push.p.inertia(i));
    move(i, 0, here, all.x, given.x, inverse_mass);
    move(i, 1, here, all.y, given.y, inverse_mass);
    turn(i, here, all.torque, given.torque, inverse_inertia);
  }
};

}  // namespace

template <class Keeper>
void integrate(const Queue& queue, const StepControl& control, const Bonds& bonds, const Contacts& contacts,
               const BoundaryLoads& loads, const Particles& particles, const Keeper& accounts, const Groups* awake) {
  const char* label = "vug::dem::integrate";
  GatherContacts gather = gather_loads(bonds, contacts);
  Integrate<Keeper> move{
      control, particle_push(control.load_factor, control.surroundings, bonds, contacts, loads, particles), accounts};
  if (awake)
    launch(queue, label, in_turn(queue.exec, *awake, std::move(gather), std::move(move)));
  else
    launch(queue, label, in_turn(particles.count, std::move(gather), std::move(move)));
}

VUG_COMPILE(integrate<NoAccounts>)
VUG_COMPILE(integrate<Accounts>)

}  // namespace vug
