// The energy ledger: work = kinetic + elastic + fracture + friction + damping.
#include "dem/edges.hpp"
#include "dem/laboratory.hpp"
#include "dem_support.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace {

using namespace vug;
using vug::test::elastic;
using vug::test::host_copy;

TEST(EnergyLedger, ClosesThroughBreakingAndItsErrorFallsWithTheStep) {
  const auto imbalance = [](double fraction) {
    MechanicsParameters parameters;
    parameters.energy_ledger = true;
    parameters.bond.cohesion = 30e6;
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
  double before = 0;
  for (const double fraction : {0.3, 0.15, 0.075}) {
    const double error = imbalance(fraction);
    test::record("energy_ledger", {{"fraction", fraction}, {"imbalance", error}});
    if (before > 0) {
      EXPECT_LT(error, before / 3);  // a quarter
    }
    before = error;
  }
  EXPECT_LT(before, 1e-5);
}

/// Missing energy over the initial one after a corner has hit an edge obliquely, slid, turned and flown off again,
/// `phase` of a step later than else.
double collision_imbalance(double fraction, double phase) {
  const double l = 2e-3, height = l * std::sqrt(3.0) / 2, step = 6e-7 * fraction;  // about
  const double gap = 1e-5 + 2 * phase * step;
  const Assembly assembly{{{0, 0}, {0, l}, {-height, l / 2}, {gap, l / 2}, {gap + height, 0}, {gap + height, l}},
                          {{0, 1, 2}, {3, 4, 5}},
                          {}};
  MechanicsParameters parameters;
  parameters.energy_ledger = true;
  parameters.contact.tangential_damping = 500;
  Mechanics rock(assembly, parameters, {});
  const auto v = host_copy(rock.particles().v);
  const auto spin = host_copy(rock.particles().spin);
  v(0, 0) = 1, v(1, 0) = -1, v(1, 1) = 2, spin(0) = 200;
  Kokkos::deep_copy(rock.particles().v, v);
  Kokkos::deep_copy(rock.particles().spin, spin);
  const Exec exec;
  rock.reset_ledger(exec);
  const double dt = fraction * rock.critical_step();
  rock.advance(exec, dt, static_cast<int>(1.5e-4 / dt));
  const Energies e = rock.energies(exec);
  EXPECT_GT(e.friction, 0.01 * e.initial);
  EXPECT_GT(e.damping, 0.01 * e.initial);
  EXPECT_LT(host_copy(rock.particles().v)(0, 0), 0);
  return e.imbalance() / e.initial;
}

TEST(EnergyLedger, OfAnObliqueCollisionClosesToSecondOrder) {
  // faces touch and part at some place within a step: the mean square over sixteen places
  double before = 0;
  for (const double fraction : {0.2, 0.1, 0.05, 0.025}) {
    double square = 0;
    for (int k = 0; k < 16; ++k) square += std::pow(collision_imbalance(fraction, k / 16.0), 2) / 16;
    const double error = std::sqrt(square);
    test::record("energy_collision", {{"fraction", fraction}, {"imbalance", error}});
    if (before > 0) {
      EXPECT_LT(error, before / 3);  // a quarter
    }
    before = error;
  }
  EXPECT_LT(before, 1e-4);
}

TEST(EnergyLedger, ClosesToSecondOrderWhileTheRockIsElastic) {
  const auto imbalance = [](double fraction, double mass_scaling) {
    MechanicsParameters parameters = elastic();
    parameters.energy_ledger = true;
    parameters.mass_scaling = mass_scaling;
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
  for (const double scaling : {1.0, 4.0}) {
    const double coarse = imbalance(0.3, scaling), fine = imbalance(0.1, scaling);
    if (scaling == 1) test::record("energy_elastic", {{"coarse", coarse}, {"fine", fine}});
    EXPECT_LT(coarse, 1e-7) << scaling;
    EXPECT_LT(fine, coarse / 5) << scaling;  // second order would be a ninth, and round-off of 1e-12
  }
}

/// Missing energy over the work of a compression test until the specimen is crushed.
double compression_imbalance(const Assembly& specimen, std::uint64_t seed, double speed, double fraction) {
  MechanicsParameters parameters;
  parameters.bond.cohesion = 60e6;
  parameters.bond.seed = seed;
  parameters.energy_ledger = true;
  PlatenTest compression;
  compression.speed = speed;
  compression.step_fraction = fraction;
  const PlatenResult r = load_between_platens(Exec(), specimen, parameters, compression);
  EXPECT_GT(r.bonds_at_end.failed(), 40);
  EXPECT_GT(r.energies.friction, 0.05 * r.energies.work);
  return std::abs(r.energies.imbalance()) / r.energies.work;
}

TEST(EnergyLedger, OfASpecimenThatIsCrushedClosesToSecondOrder) {
  // cracks open and close, rubble rubs and rolls from corners to edges: one force that jumps would leave an error that
  // no step makes smaller
  for (const std::uint64_t seed : {1, 5, 6}) {
    double before = 0;
    for (const double fraction : {0.4, 0.2, 0.1}) {
      const double error = compression_imbalance(test::block(0.015, 0.03, 2e-3, 0.25), seed, 2, fraction);
      test::record("energy_crushed", {{"seed", static_cast<int>(seed)}, {"fraction", fraction}, {"imbalance", error}});
      if (before > 0) {
        EXPECT_LT(error, before / 3) << seed << ' ' << fraction;  // a quarter
      }
      before = error;
    }
    EXPECT_LT(before, 5e-6) << seed;
  }
}

TEST(EnergyLedger, OfSoftRockClosesAlthoughItsOutlinesOverlapWhenTheFirstBondFails) {
  // compressed by percents: contacts that began with this overlap would bring thirty times the work out of nothing
  MechanicsParameters parameters;
  parameters.bond.normal_modulus = 1e9;
  parameters.bond.tangential_modulus = 0.44e9;
  parameters.bond.cohesion = 15e6;
  parameters.energy_ledger = true;
  PlatenTest compression;
  compression.speed = 1;
  compression.largest_strain = 0.1;
  const auto crushed = [&](double radius_factor, double chemical_damage = 0) {
    parameters.contact.radius_factor = radius_factor;
    compression.chemical_damage = chemical_damage;
    return load_between_platens(Exec(), test::block(0.015, 0.03, 2e-3, 0.25), parameters, compression);
  };
  const PlatenResult small_radius = crushed(0.1), large_radius = crushed(0.9);
  for (const PlatenResult& r : {small_radius, large_radius}) {
    EXPECT_GT(r.bonds_at_end.failed(), 20);
    EXPECT_LT(std::abs(r.energies.imbalance()), 1e-4 * r.energies.work);
  }
  EXPECT_NEAR(small_radius.strength, large_radius.strength, 0.05 * large_radius.strength);
  // bonds that are nearly dissolved: faces slide past each other while they are pressed together
  const PlatenResult aged = crushed(0.1, 0.8);
  EXPECT_GT(aged.bonds_at_end.failed(), 20);
  EXPECT_LT(std::abs(aged.energies.imbalance()), 2e-3 * aged.energies.work);
}

/// Soft rock that does not break, with single cracks from the start: bonds around their ends carry the load alone.
TEST(Contacts, BesideCracksDoNotStiffenWhatBondsHold) {
  MechanicsParameters parameters = elastic();
  parameters.bond.normal_modulus = 1e9;
  parameters.bond.tangential_modulus = 0.44e9;
  PlatenTest compression;
  compression.speed = 2;
  compression.largest_strain = 0.05;
  Assembly cracked = test::block(0.01, 0.02, 2e-3, 0.2);
  std::set<int> taken;  // vertices: no crack meets another one or the surface
  const std::vector<Edge> edges = find_edges(cracked);
  for (const Edge& edge : edges)
    if (edge.triangle[1] < 0) taken.insert(edge.vertex.begin(), edge.vertex.end());
  for (const Edge& edge : edges) {
    const auto [low, high] = std::minmax(edge.vertex[0], edge.vertex[1]);
    if (taken.contains(low) || taken.contains(high)) continue;
    cracked.initial_cracks.push_back({low, high});
    taken.insert({low, high});
  }
  const auto stress_at_the_end = [&](double radius_factor) {
    parameters.contact.radius_factor = radius_factor;
    return load_between_platens(Exec(), cracked, parameters, compression).stress.back();
  };
  const double of_sharp_corners = stress_at_the_end(0.1), of_round_ones = stress_at_the_end(0.9);
  EXPECT_NEAR(of_sharp_corners, of_round_ones, 1e-3 * of_round_ones);
}

TEST(EnergyLedgerLong, ClosesThroughAWholeCompressionTest) {
  double before = 0;
  for (const double fraction : {0.3, 0.15}) {
    const double error = compression_imbalance(test::block(0.05, 0.1, 2e-3, 0.25), 1, 0.5, fraction);
    test::record("energy_compression", {{"fraction", fraction}, {"imbalance", error}});
    EXPECT_LT(error, 1e-4);
    if (before > 0) {
      EXPECT_LT(error, before / 2.5);  // a quarter
    }
    before = error;
  }
}

}  // namespace
