#pragma once
// Force and torque on one particle: the sum that moves it, and that decides whether it rests.
#include "dem/contacts.hpp"
#include "dem/loads.hpp"

namespace vug {

struct Push {
  double x = 0, y = 0, torque = 0;  ///< N, N, N m
};

/// Sums the stored forces on a particle: its bonds' slots in a fixed order, its contacts as gathered in Contacts::push,
/// outside forces, boundary loads and gravity. It has no branches, so that a host computes eight particles at once.
struct ParticlePush {
  double load_factor, surroundings;                        ///< see StepControl
  Kokkos::View<int* [3], Kokkos::LayoutLeft> slot;         ///< of Bonds
  Kokkos::View<double* [4], Kokkos::LayoutLeft> load;      ///< of Bonds
  Kokkos::View<double* [3], Kokkos::LayoutLeft> contacts;  ///< Contacts::push
  BoundaryLoads boundary;
  Particles p;

  KOKKOS_FORCEINLINE_FUNCTION Push bond(int i, int edge) const {
    const int k = slot(i, edge) / 2, end = slot(i, edge) % 2;
    const double sign = 1 - 2 * end;
    return {sign * load(k, 0), sign * load(k, 1), load(k, 2 + end)};
  }

  /// Force of the rock beyond the boundary in addition to the stress after the preload.
  KOKKOS_FORCEINLINE_FUNCTION double spring(int i, int axis) const {
    return surroundings * boundary.stiffness(i, axis) * (p.u(i, axis) - p.u_reference(i, axis));
  }

  /// Sum of what does not come from other particles; zero for rock that is gone.
  KOKKOS_FORCEINLINE_FUNCTION Push outside(int i) const {
    const double weight = p.mass(i) * mass_fraction(p.solid_fraction(i));
    const double a = boundary.moment(i, 0), b = boundary.moment(i, 1);
    const double moment = a + p.rotation(i, 0) * a - p.rotation(i, 1) * b;
    const double here = presence(p.solid_fraction(i));
    return {here * (p.force(i, 0) + load_factor * (boundary.force(i, 0) + weight * boundary.gravity_x) - spring(i, 0)),
            here * (p.force(i, 1) + load_factor * (boundary.force(i, 1) + weight * boundary.gravity_y) - spring(i, 1)),
            here * (p.torque(i) + load_factor * moment)};
  }

  /// Sum of everything; `given` is outside(i).
  KOKKOS_FORCEINLINE_FUNCTION Push total(int i, const Push& given) const {
    const Push a = bond(i, 0), b = bond(i, 1), c = bond(i, 2);
    return {a.x + b.x + c.x + contacts(i, 0) + given.x, a.y + b.y + c.y + contacts(i, 1) + given.y,
            a.torque + b.torque + c.torque + contacts(i, 2) + given.torque};
  }

  /// Stores in `reaction` the forces that hold a particle against the sum `all`.
  KOKKOS_FORCEINLINE_FUNCTION void hold(int i, const Push& all) const {
    p.reaction(i, 0) = (p.held(i) & 1) != 0 ? -all.x : 0.0;
    p.reaction(i, 1) = (p.held(i) & 2) != 0 ? -all.y : 0.0;
  }
};

inline ParticlePush particle_push(double load_factor, double surroundings, const Bonds& bonds, const Contacts& contacts,
                                  const BoundaryLoads& loads, const Particles& particles) {
  return {load_factor, surroundings, bonds.slot, bonds.load, contacts.push, loads, particles};
}

}  // namespace vug
