#pragma once
// One bond without scatter or viscosity, its faces moved by hand.
#include "dem/bond_law.hpp"
#include "dem/forces.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <array>

namespace vug::test {

class OneBond : public ::testing::Test {
 protected:
  static constexpr double l = 2e-3;

  OneBond() {
    parameters.bond.weibull_shape = 0;
    parameters.bond.damping = 0;
    const Assembly assembly = pair_of_triangles(l);
    particles = make_particles(assembly, parameters);
    bonds = make_bonds(assembly, particles, parameters);
  }

  double bond_length() const { return parameters.bond.length_factor * l / std::sqrt(3.0); }

  void set_bond_length(double length) { parameters.bond.length_factor = length / (l / std::sqrt(3.0)); }

  /// Mean stress (normal, tangential) after particle b has moved to (u_n, u_t).
  std::array<double, 2> stress_at(double u_n, double u_t) {
    place(particles, 1, u_n, u_t);
    compute_forces(Exec(), parameters, 0, particles, bonds, make_contacts(particles, bonds, false), NoAccounts{});
    const auto load = host_copy(bonds.load);
    return {load(0, 0) / l, load(0, 1) / l};
  }

  /// Work per area, J/m2, of a bond that is drawn straight until b has gone to (u_n, u_t).
  double work_until(double u_n, double u_t) {
    constexpr int steps = 20000;
    double work = 0;
    std::array<double, 2> before{};
    for (int k = 1; k <= steps; ++k) {
      const auto stress = stress_at(u_n * k / steps, u_t * k / steps);
      work += 0.5 * ((before[0] + stress[0]) * u_n + (before[1] + stress[1]) * u_t) / steps;
      before = stress;
    }
    return work;
  }

  BondState state() const { return host_copy(bonds.state)(0); }

  MechanicsParameters parameters;
  Particles particles;
  Bonds bonds;
};

}  // namespace vug::test
