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

/// (1 - d) (k_n delta_n^2 + k_t delta_t^2) / 2 over the edge of one bond; for a crack its compression and the stretch
/// of its friction spring.
struct ElasticEnergy {
  BondParameters law;
  double failure_at;
  double expansion;
  double half_step;
  Particles particles;
  Bonds bonds;

  /// Where particle i was when its velocity was that of now.
  KOKKOS_FUNCTION EndMotion earlier(int i) const {
    EndMotion m = motion_of(particles, expansion, i);
    m.u = m.u - half_step * m.v;
    m.rotation = Rotation::by(particles.angle(i) - half_step * m.spin);
    return m;
  }

  KOKKOS_FUNCTION double operator()(int k) const {
    const EndMotion a = earlier(bonds.pair(k, 0)), b = earlier(bonds.pair(k, 1));
    const auto [frame, opening] = motion_of_bond(a, b, bonds, k);
    const double d_c = Kokkos::min(bonds.d_c(k), failure_at);
    const double length = law.length_factor * bonds.spacing(k);
    const bool failed = has_failed(bonds.state(k));
    if (bonds.joint(k) == 0) return 0;
    double sum = 0;
    for (int s = 0; s < 2; ++s) {
      const double d_m = bonds.point_damage(k, s), n = opening[s].delta_n;
      const double stretch = failed ? (n < 0 ? opening[s].delta_t - bonds.slip(k, s) : 0) : opening[s].delta_t;
      sum += normal_integrity(d_m, n) * law.normal_modulus * n * n +
             (failed ? 1 : 1 - d_m) * law.tangential_modulus * stretch * stretch;
    }
    return 0.25 * bonds.length(k) * (1 - d_c) / length * sum;
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

Accounts make_accounts(const Particles& particles, const Bonds& bonds) {
  const auto fresh = [](const char* label, int n) {
    return ScalarField<double>(std::string("vug::dem::account_") + label, static_cast<std::size_t>(n));
  };
  return {fresh("fracture", bonds.count),         fresh("friction", bonds.count),
          fresh("damping", bonds.count),          fresh("pair_friction", particles.count),
          fresh("pair_damping", particles.count), fresh("work", particles.count),
          fresh("local_damping", particles.count)};
}

void reset(const Exec& exec, const Accounts& a) {
  for (const auto& account : {a.bond_fracture, a.bond_friction, a.bond_damping, a.pair_friction, a.pair_damping,
                              a.particle_work, a.particle_damping}) {
    Kokkos::deep_copy(exec, account, 0.0);
  }
}

Energies measure_energies(const Exec& exec, const MechanicsParameters& parameters, double dt,
                          const Particles& particles, const Bonds& bonds, const Contacts& contacts,
                          const std::optional<Accounts>& accounts) {
  Energies e;
  e.kinetic =
      total(exec, "vug::dem::kinetic_energy", particles.count, KineticEnergy{parameters.mass_scaling, particles});
  e.elastic = total(exec, "vug::dem::elastic_energy", bonds.count,
                    ElasticEnergy{parameters.bond, parameters.chemical.failure_at, parameters.thermal_expansion,
                                  0.5 * dt, particles, bonds}) +
              total(exec, contacts.energy);
  if (accounts) {
    e.work = total(exec, accounts->particle_work);
    e.fracture = total(exec, accounts->bond_fracture);
    e.friction = total(exec, accounts->bond_friction) + total(exec, accounts->pair_friction);
    e.damping = total(exec, accounts->bond_damping) + total(exec, accounts->pair_damping) +
                total(exec, accounts->particle_damping);
  }
  return e;
}

}  // namespace vug
