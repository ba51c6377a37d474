#include "dem/integrate.hpp"

#include "dem/gather_contacts.hpp"
#include "kernels/launch_in_turn.hpp"

namespace vug {

namespace {

/// Everything that pushes one particle.
struct Push {
  double x = 0, y = 0, torque = 0;
};

/// One particle: the sum of its bonds' slots in fixed order, its contacts, outside forces, boundary loads and gravity;
/// local damping F -= alpha |F| sign(v); held axes follow their platen and leave the force that holds them in
/// `reaction`. No branches and no calls, so that a host moves eight particles at once.
/// Reads about 45 numbers, writes 11. Conserves momentum up to the sum of the outside forces.
template <class Keeper>
struct Integrate {
  StepControl control;
  Bonds bonds;
  Contacts contacts;
  BoundaryLoads boundary;
  Particles p;
  Keeper accounts;

  KOKKOS_FORCEINLINE_FUNCTION Push bond(int i, int edge) const {
    const int slot = bonds.slot(i, edge), k = slot / 2, end = slot % 2;
    const double sign = 1 - 2 * end;
    return {sign * bonds.load(k, 0), sign * bonds.load(k, 1), bonds.load(k, 2 + end)};
  }

  /// What the rock beyond the boundary adds to the stress that was there after the preload.
  KOKKOS_FORCEINLINE_FUNCTION double spring(int i, int axis) const {
    return control.surroundings * boundary.stiffness(i, axis) * (p.u(i, axis) - p.u_reference(i, axis));
  }

  KOKKOS_FORCEINLINE_FUNCTION Push outside(int i) const {
    const double weight = p.mass(i) * mass_fraction(p.solid_fraction(i));
    const double a = boundary.moment(i, 0), b = boundary.moment(i, 1);
    const double moment = a + p.rotation(i, 0) * a - p.rotation(i, 1) * b;
    return {p.force(i, 0) + control.load_factor * (boundary.force(i, 0) + weight * boundary.gravity_x) - spring(i, 0),
            p.force(i, 1) + control.load_factor * (boundary.force(i, 1) + weight * boundary.gravity_y) - spring(i, 1),
            p.torque(i) + control.load_factor * moment};
  }

  /// New velocity of one degree of freedom under `force`.
  KOKKOS_FORCEINLINE_FUNCTION double kicked(double v, double force, double inverse_mass) const {
    const double against = v > 0 ? -1 : v < 0 ? 1 : 0;
    return v + control.dt * inverse_mass * (force + control.local_damping * Kokkos::abs(force) * against);
  }

  /// What local damping takes when the velocity goes from v to w.
  KOKKOS_FORCEINLINE_FUNCTION double damped(double v, double w, double force) const {
    const double along = v > 0 ? 1 : v < 0 ? -1 : 0;
    return control.dt * control.local_damping * Kokkos::abs(force) * along * 0.5 * (v + w);
  }

  /// What the dashpots of its contacts take from one degree of freedom.
  KOKKOS_FORCEINLINE_FUNCTION double dragged(int i, int component, double v, double w) const {
    return -control.dt * accounts.particle_drag(i, component) * 0.5 * (v + w);
  }

  /// Moves one degree of freedom; work of `given` forces and of the platen, and damping, go to the accounts.
  KOKKOS_FORCEINLINE_FUNCTION void move(int i, int axis, double force, double given, double inverse_mass) const {
    const bool held = (p.held(i) & (axis == 0 ? 1 : 2)) != 0;
    const double v = p.v(i, axis), kick = kicked(v, force, inverse_mass), w = held ? p.drive(i, axis) : kick;
    p.v(i, axis) = w;
    p.u(i, axis) += control.dt * w;
    p.reaction(i, axis) = held ? -force : 0.0;
    if constexpr (Keeper::kept) {
      const double jerk = 0.5 * (w * w - v * v) / inverse_mass;  // of a platen that changes its speed
      accounts.add_particle(
          i, held ? control.dt * (given - force) * 0.5 * (v + w) + jerk : control.dt * given * 0.5 * (v + w),
          (held ? 0 : damped(v, w, force)) + dragged(i, axis, v, w));
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION void turn(int i, double torque, double given, double inverse_inertia) const {
    const bool held = (p.held(i) & 4) != 0;
    const double v = p.spin(i), kick = kicked(v, torque, inverse_inertia), w = held ? 0.0 : kick;
    const double angle = p.angle(i) + control.dt * w;
    const Rotation rotation = Rotation::by(angle);
    p.spin(i) = w;
    p.angle(i) = angle;
    p.rotation(i, 0) = rotation.cos_minus_1;
    p.rotation(i, 1) = rotation.sin;
    if constexpr (Keeper::kept) {
      accounts.add_particle(i, held ? 0 : control.dt * given * 0.5 * (v + w),
                            (held ? 0 : damped(v, w, torque)) + dragged(i, 2, v, w));
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION void operator()(int i) const {
    const Push a = bond(i, 0), b = bond(i, 1), c = bond(i, 2), given = outside(i);
    const double share = control.mass_scaling * mass_fraction(p.solid_fraction(i));
    const double inverse_mass = 1 / (share * p.mass(i)), inverse_inertia = 1 / (share * p.inertia(i));
    const double x = a.x + b.x + c.x + contacts.push(i, 0) + given.x;
    const double y = a.y + b.y + c.y + contacts.push(i, 1) + given.y;
    const double torque = a.torque + b.torque + c.torque + contacts.push(i, 2) + given.torque;
    move(i, 0, x, given.x, inverse_mass);
    move(i, 1, y, given.y, inverse_mass);
    turn(i, torque, given.torque, inverse_inertia);
  }
};

}  // namespace

template <class Keeper>
void integrate(const Exec& exec, const StepControl& control, const Bonds& bonds, const Contacts& contacts,
               const BoundaryLoads& loads, const Particles& particles, const Keeper& accounts) {
  for_each_node_in_turn(exec, "vug::dem::integrate", particles.count,
                        GatherContacts{bonds, contacts, contacts.load, contacts.push},
                        Integrate<Keeper>{control, bonds, contacts, loads, particles, accounts});
}

template void integrate(const Exec&, const StepControl&, const Bonds&, const Contacts&, const BoundaryLoads&,
                        const Particles&, const NoAccounts&);
template void integrate(const Exec&, const StepControl&, const Bonds&, const Contacts&, const BoundaryLoads&,
                        const Particles&, const Accounts&);

}  // namespace vug
