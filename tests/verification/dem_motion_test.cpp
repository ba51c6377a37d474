// Bodies that move: conservation of momentum and energy, the critical step, waves.
#include "dem_support.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

namespace {

using namespace vug;
using vug::test::elastic;
using vug::test::host_copy;

TEST(FreeBody, KeepsItsMomentumAndAngularMomentum) {
  MechanicsParameters parameters;  // damped and breakable: internal forces must still cancel
  Mechanics rock(test::block(0.01, 0.01, 2e-3, 0.2), parameters, {});
  const Particles& p = rock.particles();
  const auto v = host_copy(p.v);
  const auto spin = host_copy(p.spin);
  const auto x0 = host_copy(p.x0);
  for (int i = 0; i < p.count; ++i) {  // translation, rotation, and a shock that breaks bonds
    v(i, 0) = 1 - 300 * (x0(i, 1) - 0.005) + (i % 7 == 0 ? 40 : 0);
    v(i, 1) = 2 + 300 * (x0(i, 0) - 0.005);
    spin(i) = 300;
  }
  Kokkos::deep_copy(p.v, v);
  Kokkos::deep_copy(p.spin, spin);
  const double dt = 0.3 * rock.critical_step();
  rock.advance(Exec(), dt, 1);
  const test::Momenta before = test::momenta(p, dt);
  rock.advance(Exec(), dt, 2000);
  const test::Momenta after = test::momenta(p, dt);
  EXPECT_GT(rock.bond_counts().failed(), 0);
  EXPECT_NEAR(after.x, before.x, 1e-12 * std::abs(before.x));
  EXPECT_NEAR(after.y, before.y, 1e-12 * std::abs(before.y));
  EXPECT_NEAR(after.angular, before.angular, 1e-12 * before.scale);
}

/// u = g dt^2 n (n + 1) / 2 after n steps of the leapfrog; what has dissolved takes its weight along.
TEST(FreeBody, FallsWithGravityAlsoWhenHalfOfItIsDissolved) {
  Loads loads;
  loads.gravity = {0.7, -9.81};
  Mechanics rock(test::pair_of_triangles(2e-3), elastic(), loads);
  const Particles& p = rock.particles();
  const double dt = 0.1 * rock.critical_step();
  const ScalarField<double> left("left", p.count), d_c("d_c", rock.bonds().count);
  Kokkos::deep_copy(left, 0.5);
  rock.dissolve(Exec(), dt, left, d_c);
  constexpr int steps = 1000;
  rock.advance(Exec(), dt, steps);
  const auto u = host_copy(p.u);
  const double fallen = dt * dt * steps * (steps + 1) / 2;
  for (int i = 0; i < p.count; ++i) {
    EXPECT_NEAR(u(i, 0) / (0.7 * fallen), 1, 1e-9);
    EXPECT_NEAR(u(i, 1) / (-9.81 * fallen), 1, 1e-9);
  }
}

TEST(TwoBondedTriangles, KeepTheirEnergyForAHundredThousandSteps) {
  Mechanics rock(test::pair_of_triangles(2e-3), elastic(), {});
  const Particles& p = rock.particles();
  const auto v = host_copy(p.v);
  const auto spin = host_copy(p.spin);
  v(0, 0) = 0.1, v(0, 1) = -0.05, spin(1) = 50;
  Kokkos::deep_copy(p.v, v);
  Kokkos::deep_copy(p.spin, spin);
  const double dt = 0.01 * rock.critical_step();
  // The leapfrog's energy oscillates by (omega dt)^2 / 8, here 5e-5; it must not drift.
  const auto energy = [&] {
    rock.advance(Exec(), dt, 1);
    const Energies e = rock.energies(Exec());
    return e.kinetic + e.elastic;
  };
  const double start = energy();
  double worst = 0;
  for (int look = 0; look < 100; ++look) {
    rock.advance(Exec(), dt, 999);
    worst = std::max(worst, std::abs(energy() / start - 1));
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(RockAtRest, StaysExactlyAtRest) {
  Mechanics rock(test::block(0.01, 0.01, 2e-3, 0.2), {}, {});
  rock.advance(Exec(), 0.3 * rock.critical_step(), 100);
  const auto u = host_copy(rock.particles().u);
  for (int i = 0; i < rock.particles().count; ++i) EXPECT_TRUE(u(i, 0) == 0 && u(i, 1) == 0);
}

TEST(CriticalStep, IsSafeAndNotWasteful) {
  // growth of a small random disturbance tells on which side of the limit a step is
  const auto grows = [](double factor) {
    MechanicsParameters parameters = elastic();
    parameters.contact.normal_stiffness = parameters.contact.tangential_stiffness = 1;  // bonds alone
    parameters.contact.normal_damping = 0;
    Mechanics rock(test::block(0.02, 0.02, 2e-3, 0.25), parameters, {});
    const auto v = host_copy(rock.particles().v);
    for (int i = 0; i < rock.particles().count; ++i) v(i, i % 2) = 1e-6 * (i % 5 - 2);
    Kokkos::deep_copy(rock.particles().v, v);
    const double dt = factor * rock.critical_step();
    const double before = rock.energies(Exec()).kinetic;
    rock.advance(Exec(), dt, 2000);
    return !(rock.energies(Exec()).kinetic < 100 * before);
  };
  EXPECT_FALSE(grows(0.99));
  EXPECT_TRUE(grows(1.5));
}

TEST(ElasticBar, CarriesAPulseAtTheSpeedOfItsModulus) {
  // a thin free bar struck at its left end: the stress front passes two gauges
  const double length = 0.2, height = 0.0104;
  Loads loads;
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.velocity[static_cast<std::size_t>(RockSide::left)] = {0.01, 0};
  Mechanics bar(test::block(length, height, 2e-3, 0.2), elastic(), loads);
  const auto x0 = host_copy(bar.particles().x0);
  const double dt = 0.3 * bar.critical_step();
  const double place[2] = {0.05, 0.15};
  double arrival[2] = {0, 0};
  while (bar.time() < 7e-5) {
    bar.advance(Exec(), dt, 5);
    const auto now = host_copy(bar.particles().v);
    for (int g = 0; g < 2; ++g) {
      double mean = 0, n = 0;
      for (int i = 0; i < bar.particles().count; ++i) {
        if (std::abs(x0(i, 0) - place[g]) < 2.5e-3) mean += now(i, 0), n += 1;
      }
      test::record("bar_pulse", {{"place", place[g]}, {"time", bar.time()}, {"velocity", mean / n}});
      if (arrival[g] == 0 && mean / n > 0.005) arrival[g] = bar.time();
    }
  }
  const double speed = (place[1] - place[0]) / (arrival[1] - arrival[0]);
  test::record("bar_speed", {{"speed", speed}, {"exact", std::sqrt(28.3e9 / 2500)}});
  // bar velocity sqrt(E / rho) with the modulus of this mesh, 28.3 GPa (3365 m/s); the front's middle is meant by half
  // its height; time is known to 5 steps of 30 microseconds' travel
  EXPECT_NEAR(speed, std::sqrt(28.3e9 / 2500), 0.02 * std::sqrt(28.3e9 / 2500));
}

}  // namespace
