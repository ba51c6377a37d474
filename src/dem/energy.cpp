#include "dem/energy.hpp"

#include "dem/elastic_energy.hpp"
#include "kernels/launch/launch.hpp"

namespace vug {

namespace {

/// Kinetic energy of one particle, m v^2 / 2 + I spin^2 / 2.
struct KineticEnergy {
  double mass_scaling;
  Particles p;
  KOKKOS_FUNCTION double operator()(int i) const {
    const double v2 = p.v(i, 0) * p.v(i, 0) + p.v(i, 1) * p.v(i, 1);
    const double share = mass_scaling * mass_fraction(p.solid_fraction(i));
    return 0.5 * share * (p.mass(i) * v2 + p.inertia(i) * p.spin(i) * p.spin(i));
  }
};

/// Half step of dashpot work that the sums do not contain yet.
struct PendingDrag {
  double expansion;
  double dt;
  Particles particles;
  Bonds bonds;
  Accounts accounts;
  KOKKOS_FUNCTION double operator()(int k) const {
    const BondMotion now = motion_of_bond(particles, bonds, expansion, k);
    double power = 0;
    for (int s = 0; s < 2; ++s)
      power +=
          accounts.drag_before(k, s, 0) * now.opening[s].rate_n + accounts.drag_before(k, s, 1) * now.opening[s].rate_t;
    return 0.25 * dt * bonds.length(k) * power;
  }
};

double total(const Exec& exec, const ScalarField<double>& values) {
  return sum_of_list(exec, "vug::dem::sum_account", static_cast<int>(values.extent(0)), ValueOf{values});
}

}  // namespace

Accounts make_accounts(const Particles& particles, const Bonds& bonds, const Contacts& contacts) {
  Accounts a;
  make_zeros(a.bond_drag, "vug::dem::account_drag", bonds.count);
  make_zeros(a.bond_fracture, "vug::dem::account_fracture", bonds.count);
  make_zeros(a.bond_friction, "vug::dem::account_friction", bonds.count);
  make_zeros(a.bond_damping, "vug::dem::account_damping", bonds.count);
  make_zeros(a.pair_friction, "vug::dem::account_pair_friction", particles.count);
  make_zeros(a.pair_drag, "vug::dem::account_pair_drag", contacts.capacity);
  make_zeros(a.particle_drag, "vug::dem::account_particle_drag", particles.count);
  make_zeros(a.particle_work, "vug::dem::account_work", particles.count);
  make_zeros(a.particle_damping, "vug::dem::account_local_damping", particles.count);
  return a;
}

void reset(const Exec& exec, const Accounts& a) {
  for (const auto& account :
       {a.bond_fracture, a.bond_friction, a.bond_damping, a.pair_friction, a.particle_work, a.particle_damping}) {
    Kokkos::deep_copy(exec, account, 0.0);
  }
  Kokkos::deep_copy(exec, a.bond_drag, 0.0);
}

Energies measure_energies(const Exec& exec, const MechanicsParameters& parameters, double dt,
                          const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                          const std::optional<Accounts>& accounts) {
  Energies e;
  e.kinetic =
      sum_of_list(exec, "vug::dem::kinetic_energy", particles.count, KineticEnergy{parameters.mass_scaling, particles});
  e.elastic = sum_of_list(exec, "vug::dem::elastic_energy", bonds.count,
                          ElasticEnergy{parameters.bond, parameters.thermal_expansion, dt, particles, bonds}) +
              total(exec, contacts.energy);
  if (accounts) {
    e.work = total(exec, accounts->particle_work);
    e.fracture = total(exec, accounts->bond_fracture);
    e.friction = total(exec, accounts->bond_friction) + total(exec, accounts->pair_friction);
    e.damping = total(exec, accounts->bond_damping) + total(exec, accounts->particle_damping) +
                sum_of_list(exec, "vug::dem::pending_drag", bonds.count,
                            PendingDrag{parameters.thermal_expansion, dt, particles, bonds, *accounts});
  }
  return e;
}

}  // namespace vug
