// The paper's uniaxial compression (section 3.5.2): 10 cm x 5 cm between frictionless platens, Table 1, elements of 2
// mm.
#include "dem/laboratory.hpp"
#include "dem_support.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace vug;

Assembly specimen() {
  return test::block(0.05, 0.1, 2e-3, 0.25);
}

MechanicsParameters profile(double cohesion, std::uint64_t seed) {
  MechanicsParameters p;
  p.bond.cohesion = cohesion;
  p.bond.seed = seed;
  return p;
}

TEST(Laboratory, SmallSpecimenBreaksAndSaysSo) {
  PlatenTest test;
  test.speed = 2;
  const PlatenResult r = load_between_platens(Exec(), test::block(0.015, 0.03, 2.5e-3, 0.2), profile(60e6, 1), test);
  EXPECT_GT(r.bonds_at_end.failed(), r.bonds_at_peak.failed());
  EXPECT_GT(r.strength, 60e6);
  EXPECT_LT(r.strength, 150e6);
  EXPECT_NEAR(r.strength, *std::max_element(r.stress.begin(), r.stress.end()), 0);
  EXPECT_LT(r.stress.back(), 0.6 * r.strength);
}

TEST(EnergyLedgerLong, ClosesThroughAWholeCompressionTest) {
  for (const double fraction : {0.3, 0.15}) {
    MechanicsParameters parameters = profile(60e6, 1);
    parameters.energy_ledger = true;
    PlatenTest compression;
    compression.step_fraction = fraction;
    const Energies e = load_between_platens(Exec(), specimen(), parameters, compression).energies;
    const double error = std::abs(e.imbalance()) / e.work;
    vug::test::record("energy_compression", {{"fraction", fraction}, {"imbalance", error}});
    EXPECT_LT(error, 1e-4);
  }
}

}  // namespace
