#include "dem/mass_loss.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

namespace {

/// Takes mass from one triangle: p -= dm v, E -= (dm v^2 + dI spin^2) / 2.
struct TakeMass {
  ScalarField<double> now;  ///< solid fraction
  double mass_scaling;
  Particles p;
  Bonds bonds;
  MassLoss loss;
  KOKKOS_FUNCTION void operator()(int i) const {
    const double before = p.solid_fraction(i), after = now(i);
    if (after == before) return;
    const double share =
        mass_scaling * (presence(before) * mass_fraction(before) - presence(after) * mass_fraction(after));
    const Vec2 v{p.v(i, 0), p.v(i, 1)};
    loss.momentum(i, 0) += share * p.mass(i) * v.x;
    loss.momentum(i, 1) += share * p.mass(i) * v.y;
    loss.kinetic(i) += 0.5 * share * (p.mass(i) * dot(v, v) + p.inertia(i) * p.spin(i) * p.spin(i));
    p.solid_fraction(i) = after;
    if (!is_gone(after) || is_gone(before)) return;
    p.v(i, 0) = p.v(i, 1) = p.spin(i) = 0;
    Kokkos::atomic_store(&bonds.events(cracks_have_changed), 1);
  }
};

/// Takes stiffness from one bond: E -= dd_c times what it would store undissolved.
struct TakeStiffness {
  ScalarField<double> now;  ///< d_c
  ElasticEnergy energy;
  ScalarField<double> lost;
  KOKKOS_FUNCTION void operator()(int k) const {
    const ScalarField<double>& d_c = energy.bonds.d_c;
    if (now(k) <= d_c(k)) return;  // what a reaction that runs back gives to a side does not mend the bond
    lost(k) += (at_most(1, now(k)) - at_most(1, d_c(k))) * energy.undissolved(k);
    d_c(k) = now(k);
  }
};

}  // namespace

MassLoss make_mass_loss(const Particles& particles, const Bonds& bonds) {
  const int n = particles.count;
  return {VectorField<double>("vug::dem::lost_momentum", n), ScalarField<double>("vug::dem::lost_kinetic", n),
          ScalarField<double>("vug::dem::lost_elastic", bonds.count)};
}

void reset(const Exec& exec, const MassLoss& loss) {
  Kokkos::deep_copy(exec, loss.momentum, 0.0);
  Kokkos::deep_copy(exec, loss.kinetic, 0.0);
  Kokkos::deep_copy(exec, loss.elastic, 0.0);
}

void take_mass(const Exec& exec, const ScalarField<double>& solid_fraction, const ScalarField<double>& d_c,
               double mass_scaling, const ElasticEnergy& energy, const MassLoss& loss) {
  for_each_node(exec, "vug::dem::take_stiffness", energy.bonds.count, TakeStiffness{d_c, energy, loss.elastic});
  for_each_node(exec, "vug::dem::take_mass", energy.particles.count,
                TakeMass{solid_fraction, mass_scaling, energy.particles, energy.bonds, loss});
}

LostWithRock lost_with_rock(const Particles& particles, const MassLoss& loss) {
  const auto fraction = on_host(particles.solid_fraction);
  const auto momentum = on_host(loss.momentum);
  LostWithRock lost;
  for (int i = 0; i < particles.count; ++i) {
    lost.triangles += is_gone(fraction(i));
    lost.momentum = lost.momentum + Vec2{momentum(i, 0), momentum(i, 1)};
  }
  lost.kinetic = sum_in_order(loss.kinetic);
  lost.elastic = sum_in_order(loss.elastic);
  return lost;
}

}  // namespace vug
