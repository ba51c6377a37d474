#include "dem/energy.hpp"

#include "dem/bond_kinematics.hpp"
#include "dem/bond_law.hpp"
#include "kernels/launch.hpp"

#include <string>

namespace vug {

namespace {

/// m v^2 / 2 + I spin^2 / 2 of one particle.
struct KineticEnergy {
  double mass_scaling;
  Particles p;
  KOKKOS_FUNCTION double operator()(int i) const {
    const double v2 = p.v(i, 0) * p.v(i, 0) + p.v(i, 1) * p.v(i, 1);
    const double share = mass_scaling * mass_fraction(p.solid_fraction(i));
    return 0.5 * share * (p.mass(i) * v2 + p.inertia(i) * p.spin(i) * p.spin(i));
  }
};

/// (1 - d) (k_n delta_n delta_n' + k_t delta_t delta_t') / 2 over the edge of one bond, delta at the time of the last
/// forces, delta' one step later; for a crack its compression and the stretch of its friction spring.
struct ElasticEnergy {
  BondParameters law;
  double failure_at;
  double expansion;
  double dt;
  Particles particles;
  Bonds bonds;

  KOKKOS_FUNCTION double operator()(int k) const {
    if (bonds.joint(k) == 0) return 0;
    const BondMotion now = motion_of_bond(particles, bonds, expansion, k);
    const BondMotion before = motion_of_bond_before(particles, bonds, expansion, dt, k);
    const double d_c = Kokkos::min(bonds.d_c(k), failure_at);
    const double length = law.length_factor * bonds.spacing(k);
    const bool failed = has_failed(bonds.state(k));
    double sum = 0;
    for (int s = 0; s < 2; ++s) {
      const PointOpening &o = now.opening[s], &b = before.opening[s];
      const double d_m = bonds.point_damage(k, s);
      const double slip = failed ? bonds.slip(k, s) : 0;
      const double held = !failed ? 1 - d_m : b.delta_n < 0 ? 1 : 0;
      sum += normal_integrity(d_m, b.delta_n) * law.normal_modulus * b.delta_n * o.delta_n +
             held * law.tangential_modulus * (b.delta_t - slip) * (o.delta_t - slip);
    }
    return 0.25 * bonds.length(k) * (1 - d_c) / length * sum;
  }
};

/// The half step of dashpot work that the sums do not hold yet.
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

struct Value {
  ScalarField<double> values;
  KOKKOS_FUNCTION double operator()(int i) const { return values(i); }
};

template <class Body>
double total(const Exec& exec, const char* label, int n, const Body& body) {
  const ScalarField<double> blocks("vug::dem::energy_blocks", static_cast<std::size_t>(block_count(n)));
  add_per_block(exec, label, n, body, blocks);
  exec.fence("vug::dem::energy");
  return sum_in_order(blocks);
}

double total(const Exec& exec, const ScalarField<double>& values) {
  return total(exec, "vug::dem::sum_account", static_cast<int>(values.extent(0)), Value{values});
}

}  // namespace

Accounts make_accounts(const Particles& particles, const Bonds& bonds, const Contacts& contacts) {
  const auto fresh = [](const char* label, int n) {
    return ScalarField<double>(std::string("vug::dem::account_") + label, static_cast<std::size_t>(n));
  };
  return {
      Kokkos::View<double* [4], Kokkos::LayoutLeft>("vug::dem::account_drag", static_cast<std::size_t>(bonds.count)),
      fresh("fracture", bonds.count),
      fresh("friction", bonds.count),
      fresh("damping", bonds.count),
      fresh("pair_friction", particles.count),
      Kokkos::View<double* [4], Kokkos::LayoutLeft>("vug::dem::account_pair_drag",
                                                    static_cast<std::size_t>(contacts.capacity)),
      Kokkos::View<double* [3], Kokkos::LayoutLeft>("vug::dem::account_particle_drag",
                                                    static_cast<std::size_t>(particles.count)),
      fresh("work", particles.count),
      fresh("local_damping", particles.count)};
}

void reset(const Exec& exec, const Accounts& a) {
  for (const auto& account : {a.bond_fracture, a.bond_friction, a.bond_damping, a.pair_friction, a.particle_work,
                              a.particle_damping}) {
    Kokkos::deep_copy(exec, account, 0.0);
  }
  Kokkos::deep_copy(exec, a.bond_drag, 0.0);
}

Energies measure_energies(const Exec& exec, const MechanicsParameters& parameters, double dt,
                          const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                          const std::optional<Accounts>& accounts) {
  Energies e;
  e.kinetic =
      total(exec, "vug::dem::kinetic_energy", particles.count, KineticEnergy{parameters.mass_scaling, particles});
  e.elastic = total(exec, "vug::dem::elastic_energy", bonds.count,
                    ElasticEnergy{parameters.bond, parameters.chemical.failure_at, parameters.thermal_expansion, dt,
                                  particles, bonds}) +
              total(exec, contacts.energy);
  if (accounts) {
    e.work = total(exec, accounts->particle_work);
    e.fracture = total(exec, accounts->bond_fracture);
    e.friction = total(exec, accounts->bond_friction) + total(exec, accounts->pair_friction);
    e.damping = total(exec, accounts->bond_damping) + total(exec, accounts->particle_damping) +
                total(exec, "vug::dem::pending_drag", bonds.count,
                      PendingDrag{parameters.thermal_expansion, dt, particles, bonds, *accounts});
  }
  return e;
}

}  // namespace vug
