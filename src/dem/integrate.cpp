#include "dem/integrate.hpp"

#include "kernels/launch.hpp"

namespace vug {

namespace {

/// Everything that pushes one particle.
struct Push {
  Vec2 force;
  double torque = 0;
};

/// Forces of interactions and which of them act on which particle.
struct Slots {
  Kokkos::View<double* [4], Kokkos::LayoutLeft> load;
  IndexList row, entry;
};

/// One particle: the sum of its bonds' slots in row order, outside forces, boundary loads and gravity; local damping
/// F -= alpha |F| sign(v); held axes follow their platen and leave the force that holds them in `reaction`.
/// Reads about 40 numbers, writes 11. Conserves momentum up to the sum of the outside forces.
struct Integrate {
  StepControl control;
  Slots bonds, contacts;
  BoundaryLoads boundary;
  Particles p;

  /// Adds what the slots hold for particle i; the second end of a slot feels the opposite force.
  KOKKOS_FUNCTION static void gather(const Slots& slots, int i, Push& sum) {
    const auto& [load, row, entry] = slots;
    for (int e = row(i); e < row(i + 1); ++e) {
      const int k = entry(e) / 2, end = entry(e) % 2;
      const double sign = end == 0 ? 1 : -1;
      sum.force.x += sign * load(k, 0);
      sum.force.y += sign * load(k, 1);
      sum.torque += load(k, 2 + end);
    }
  }

  KOKKOS_FUNCTION Push outside_push(int i) const {
    const double weight = control.load_factor * p.mass(i) * mass_fraction(p.solid_fraction(i));
    const double a = boundary.moment(i, 0), b = boundary.moment(i, 1);
    const double moment = a + p.rotation(i, 0) * a - p.rotation(i, 1) * b;
    return {{p.force(i, 0) + control.load_factor * boundary.force(i, 0) + weight * boundary.gravity_x,
             p.force(i, 1) + control.load_factor * boundary.force(i, 1) + weight * boundary.gravity_y},
            p.torque(i) + control.load_factor * moment};
  }

  KOKKOS_FUNCTION double kicked(double v, double force, double inverse_mass) const {
    const double sign = v > 0 ? 1 : v < 0 ? -1 : 0;
    return v + control.dt * inverse_mass * (force - control.local_damping * Kokkos::abs(force) * sign);
  }

  KOKKOS_FUNCTION void move(int i, int axis, double force, double inverse_mass) const {
    const bool held = p.held(i) & 1 << axis;
    p.v(i, axis) = held ? p.drive(i, axis) : kicked(p.v(i, axis), force, inverse_mass);
    p.u(i, axis) += control.dt * p.v(i, axis);
    p.reaction(i, axis) = held ? -force : 0;
  }

  KOKKOS_FUNCTION void operator()(int i) const {
    Push push = outside_push(i);
    gather(bonds, i, push);
    gather(contacts, i, push);
    const double share = control.mass_scaling * mass_fraction(p.solid_fraction(i));
    const double inverse_mass = 1 / (share * p.mass(i));
    move(i, 0, push.force.x, inverse_mass);
    move(i, 1, push.force.y, inverse_mass);

    p.spin(i) = p.held(i) & 4 ? 0 : kicked(p.spin(i), push.torque, 1 / (share * p.inertia(i)));
    p.angle(i) += control.dt * p.spin(i);
    const Rotation rotation = Rotation::by(p.angle(i));
    p.rotation(i, 0) = rotation.cos_minus_1;
    p.rotation(i, 1) = rotation.sin;
  }
};

}  // namespace

void integrate(const Exec& exec, const StepControl& control, const Bonds& bonds, const Contacts& contacts,
               const BoundaryLoads& loads, const Particles& particles) {
  for_each_node(exec, "vug::dem::integrate", particles.count,
                Integrate{control,
                          {bonds.load, bonds.row, bonds.entry},
                          {contacts.load, contacts.row, contacts.entry},
                          loads,
                          particles});
}

}  // namespace vug
