#include "dem/energy.hpp"

#include "dem/bond_kinematics.hpp"
#include "dem/bond_law.hpp"
#include "kernels/launch.hpp"

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
  Particles particles;
  Bonds bonds;
  KOKKOS_FUNCTION double operator()(int k) const {
    const auto [frame, opening] = motion_of_bond(particles, bonds, expansion, k);
    const double d_c = Kokkos::min(bonds.d_c(k), failure_at);
    const double length = law.length_factor * bonds.spacing(k);
    const bool failed = has_failed(bonds.state(k));
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

template <class Body>
double total(const Exec& exec, const char* label, int n, const Body& body) {
  const ScalarField<double> blocks("vug::dem::energy_blocks", static_cast<std::size_t>(block_count(n)));
  add_per_block(exec, label, n, body, blocks);
  exec.fence("vug::dem::energy");
  return sum_in_order(blocks);
}

}  // namespace

Energies measure_energies(const Exec& exec, const MechanicsParameters& parameters, const Particles& particles,
                          const Bonds& bonds) {
  return {total(exec, "vug::dem::kinetic_energy", particles.count, KineticEnergy{parameters.mass_scaling, particles}),
          total(exec, "vug::dem::elastic_energy", bonds.count,
                ElasticEnergy{parameters.bond, parameters.chemical.failure_at, parameters.thermal_expansion, particles,
                              bonds})};
}

}  // namespace vug
