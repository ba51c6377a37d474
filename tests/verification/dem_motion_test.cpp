// Bodies that move: conservation, energy, heat, stiffness.
#include "dem_support.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

namespace {

using namespace vug;
using vug::test::host_copy;

MechanicsParameters elastic() {
  MechanicsParameters p;
  p.bond.normal_strength = p.bond.cohesion = 1e15;
  p.bond.damping = 0;
  return p;
}

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

TEST(ThermalExpansion, OfAFreeBlockIsExactAndLeavesNoStress) {
  const double dT = 50, alpha = 8e-6, size = 0.02;
  MechanicsParameters parameters = elastic();
  Mechanics rock(test::block(size, size, 2e-3, 0.2), parameters, {});
  const Particles& p = rock.particles();
  Kokkos::deep_copy(p.temperature_change, dT);
  const auto x0 = host_copy(p.x0);
  for (int i = 0; i < p.count; ++i) test::place(p, i, alpha * dT * x0(i, 0), alpha * dT * x0(i, 1));
  rock.advance(Exec(), 0.3 * rock.critical_step(), 1);
  const auto stress = host_copy(rock.bonds().stress);
  for (int k = 0; k < rock.bonds().count; ++k) {
    // round-off of displacements alpha dT L over the bond length
    EXPECT_LT(std::abs(stress(k, 0)), 1e-10 * 27.8e9 * alpha * dT);
    EXPECT_LT(std::abs(stress(k, 1)), 1e-10 * 27.8e9 * alpha * dT);
  }
}

TEST(ThermalExpansion, RelaxesToTheFreeShapeFromTheColdOne) {
  const double dT = -50, alpha = 8e-6;
  MechanicsParameters parameters = elastic();
  parameters.bond.damping = 4.6e-5;
  parameters.local_damping = 0.3;
  Mechanics rock(test::block(0.01, 0.01, 2e-3, 0.2), parameters, {});
  const Particles& p = rock.particles();
  Kokkos::deep_copy(p.temperature_change, dT);
  rock.advance(Exec(), 0.3 * rock.critical_step(), 20000);
  const auto x0 = host_copy(p.x0), u = host_copy(p.u);
  for (int i = 1; i < p.count; ++i) {
    const double distance = std::hypot(x0(i, 0) - x0(0, 0), x0(i, 1) - x0(0, 1));
    const double now = std::hypot(x0(i, 0) + u(i, 0) - x0(0, 0) - u(0, 0), x0(i, 1) + u(i, 1) - x0(0, 1) - u(0, 1));
    EXPECT_NEAR(now / distance - 1, alpha * dT, 1e-8 * std::abs(alpha * dT) + 1e-14);
  }
}

TEST(ThermalExpansion, OfAClampedBlockGivesTheStressOfTheBondModuli) {
  const double dT = 20, alpha = 8e-6, size = 0.04;
  MechanicsParameters parameters = elastic();
  parameters.bond.damping = 4.6e-5;
  parameters.local_damping = 0.3;
  Loads loads;
  loads.support = {Support::roller, Support::roller, Support::roller, Support::roller};
  Mechanics rock(test::block(size, size, 2e-3, 0.2), parameters, loads);
  Kokkos::deep_copy(rock.particles().temperature_change, dT);
  rock.advance(Exec(), 0.3 * rock.critical_step(), 6000);
  // sigma = -M_n / chi alpha dT: every bond is shortened by its spacing times the strain. The platens hold centroids
  // (a third of a row inside), so the reaction at a side is compared, which is the stress across the whole block.
  const double expected = 24.03e9 / 0.659 * alpha * dT * size;
  test::record("clamped_heating", {{"left", rock.reaction(RockSide::left).x / size},
                                   {"bottom", rock.reaction(RockSide::bottom).y / size},
                                   {"exact", expected / size}});
  EXPECT_NEAR(rock.reaction(RockSide::left).x, expected, 0.01 * expected);
  EXPECT_NEAR(rock.reaction(RockSide::bottom).y, expected, 0.01 * expected);
}

/// Distance between the centroids on the left and on the right side: there the rollers hold and the rock beyond pushes.
double distance_of_sides(const Mechanics& rock) {
  const auto x0 = host_copy(rock.particles().x0);
  double sum[2] = {}, n[2] = {};
  for (const BoundaryEdge& edge : rock.boundary()) {
    if (edge.side != static_cast<int>(RockSide::left) && edge.side != static_cast<int>(RockSide::right)) continue;
    const int s = edge.side == static_cast<int>(RockSide::right) ? 1 : 0;
    sum[s] += x0(edge.particle, 0);
    n[s] += 1;
  }
  return sum[1] / n[1] - sum[0] / n[0];
}

TEST(RockBeyond, CarriesTheShareOfAThermalExpansionThatItsStiffnessSays) {
  const double dT = 20, alpha = 8e-6, size = 0.02, modulus = 27.8e9;
  for (const double ratio : {0.25, 1.0, 4.0}) {  // of its stiffness to that of the block, E / L
    MechanicsParameters parameters = elastic();
    parameters.bond.damping = 4.6e-5;
    parameters.local_damping = 0.7;
    Loads loads;
    loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
    loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
    loads.stiffness[static_cast<std::size_t>(RockSide::right)] = ratio * modulus / size;
    Mechanics rock(test::block(size, size, 2e-3, 0.2), parameters, loads);
    Kokkos::deep_copy(rock.particles().temperature_change, dT);
    rock.advance(Exec(), 0.3 * rock.critical_step(), 12000);
    const Energies energies = rock.energies(Exec());
    ASSERT_LT(energies.kinetic, 1e-7 * energies.elastic) << ratio;  // a soft spring rings for long
    // two springs in series, one of which wants to be longer by its thermal expansion
    const double length = distance_of_sides(rock);
    const double expected = alpha * dT * length / (length / modulus + size / (ratio * modulus)) * size;
    EXPECT_NEAR(rock.reaction(RockSide::left).x, expected, 0.02 * expected) << ratio;
  }
}

TEST(ElasticBlock, HasTheModulusAndPoissonRatioOfTheLaboratory) {
  const double width = 0.05, height = 0.1, pressure = 1e6;
  for (const int along : {0, 1}) {
    Loads loads;
    const double size[2] = {along == 1 ? width : height, along == 1 ? height : width};
    loads.traction[static_cast<std::size_t>(along == 1 ? RockSide::top : RockSide::right)]
                  [static_cast<std::size_t>(along)] = -pressure;
    loads.traction[static_cast<std::size_t>(along == 1 ? RockSide::bottom : RockSide::left)]
                  [static_cast<std::size_t>(along)] = pressure;
    MechanicsParameters parameters = elastic();
    Mechanics rock(test::block(size[0], size[1], 2.5e-3, 0.25), parameters, loads);
    const PreloadReport report = rock.preload(Exec(), 1e-4);
    ASSERT_TRUE(report.settled);
    // strains by regression of displacements over the middle 60 %
    const auto x0 = host_copy(rock.particles().x0), u = host_copy(rock.particles().u);
    double strain[2];
    for (int axis = 0; axis < 2; ++axis) {
      double n = 0, sx = 0, su = 0, sxx = 0, sxu = 0;
      for (int i = 0; i < rock.particles().count; ++i) {
        const double place = x0(i, along) / height;
        if (place < 0.2 || place > 0.8) continue;
        n += 1, sx += x0(i, axis), su += u(i, axis), sxx += x0(i, axis) * x0(i, axis), sxu += x0(i, axis) * u(i, axis);
      }
      strain[axis] = (n * sxu - sx * su) / (n * sxx - sx * sx);
    }
    RecordProperty(along == 0 ? "modulus_x" : "modulus_y", std::to_string(-pressure / strain[along]));
    EXPECT_NEAR(-pressure / strain[along], 27.8e9, 0.03 * 27.8e9);
    // 0.237 measured on Delaunay meshes; scatter of the element layout
    RecordProperty(along == 0 ? "poisson_x" : "poisson_y", std::to_string(-strain[1 - along] / strain[along]));
    EXPECT_NEAR(-strain[1 - along] / strain[along], 0.237, 0.03);
  }
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

TEST(EnergyLedger, ClosesThroughBreakingAndItsErrorFallsWithTheStep) {
  const auto imbalance = [](double fraction, double dashpot) {
    MechanicsParameters parameters;
    parameters.energy_ledger = true;
    parameters.bond.cohesion = 30e6;
    parameters.contact.normal_damping = dashpot;
    Loads loads;
    loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
    loads.support[static_cast<std::size_t>(RockSide::top)] = Support::roller;
    loads.velocity[static_cast<std::size_t>(RockSide::top)] = {0, -2};
    Mechanics rock(test::block(0.01, 0.02, 2e-3, 0.25), parameters, loads);
    const Exec exec;
    const double dt = fraction * rock.critical_step();
    rock.advance(exec, dt, static_cast<int>(1e-4 / dt));
    const Energies e = rock.energies(exec);
    EXPECT_GT(rock.bond_counts().failed(), 5);
    EXPECT_GT(e.fracture, 0.01 * e.work);
    EXPECT_GT(e.damping, 0);
    return std::abs(e.imbalance()) / e.work;
  };
  EXPECT_LT(imbalance(0.3, 1.17e3), 1e-4);
  // the dashpots of rubble are taken at the older velocity, first order and 4e-6 of the work here; all else is second
  double before = 0;
  for (const double fraction : {0.3, 0.15, 0.075}) {
    const double error = imbalance(fraction, 0);
    test::record("energy_ledger", {{"fraction", fraction}, {"imbalance", error}});
    if (before > 0) {
      EXPECT_LT(error, before / 3);  // a quarter
    }
    before = error;
  }
}

TEST(EnergyLedger, ClosesToSecondOrderWhileTheRockIsElastic) {
  const auto imbalance = [](double fraction) {
    MechanicsParameters parameters = elastic();
    parameters.energy_ledger = true;
    parameters.bond.damping = 4.6e-6;
    Loads loads;
    loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
    loads.traction[static_cast<std::size_t>(RockSide::top)] = {1e6, -5e6};
    Mechanics rock(test::block(0.01, 0.01, 2e-3, 0.25), parameters, loads);
    const Exec exec;
    const double dt = fraction * rock.critical_step();
    rock.advance(exec, dt, static_cast<int>(2e-5 / dt));
    const Energies e = rock.energies(exec);
    return std::abs(e.imbalance()) / e.work;
  };
  const double coarse = imbalance(0.3), fine = imbalance(0.1);
  test::record("energy_elastic", {{"coarse", coarse}, {"fine", fine}});
  EXPECT_LT(coarse, 1e-7);
  EXPECT_LT(fine, coarse / 5);  // second order would be a ninth, and round-off of 1e-12
}

TEST(Preload, LeavesTheTectonicStressInTheRockAndNothingBroken) {
  Loads loads;  // rollers on the left and at the bottom, 5 MPa from the right, 7.5 MPa from the top
  loads.support[static_cast<std::size_t>(RockSide::left)] = Support::roller;
  loads.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  loads.traction[static_cast<std::size_t>(RockSide::right)] = {-5e6, 0};
  loads.traction[static_cast<std::size_t>(RockSide::top)] = {0, -7.5e6};
  const double width = 0.05, height = 0.035;
  Mechanics rock(test::block(width, height, 2.5e-3, 0.2), {}, loads);
  const PreloadReport report = rock.preload(Exec(), 5 * width / 3300);
  EXPECT_TRUE(report.settled);
  EXPECT_EQ(report.bonds.damaged + report.bonds.failed(), 0);
  EXPECT_NEAR(rock.reaction(RockSide::left).x, 5e6 * height, 1e-3 * 5e6 * height);
  EXPECT_NEAR(rock.reaction(RockSide::bottom).y, 7.5e6 * width, 1e-3 * 7.5e6 * width);
  rock.advance(Exec(), 0.3 * rock.critical_step(), 1000);
  EXPECT_LT(rock.energies(Exec()).kinetic, 1e-5 * rock.energies(Exec()).elastic);  // it stays at rest without damping
  // rock beyond the sides takes no part in the preload: the same stress, the same shape
  loads.stiffness[static_cast<std::size_t>(RockSide::right)] = 1e12;
  Mechanics backed(test::block(width, height, 2.5e-3, 0.2), {}, loads);
  backed.preload(Exec(), 5 * width / 3300);
  EXPECT_NEAR(backed.reaction(RockSide::left).x, 5e6 * height, 1e-3 * 5e6 * height);
}

}  // namespace
