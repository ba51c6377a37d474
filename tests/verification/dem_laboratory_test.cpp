// The paper's uniaxial compression (section 3.5.2): 10 cm x 5 cm between frictionless platens, Table 1, elements of 2
// mm.
#include "dem/laboratory.hpp"
#include "dem_support.hpp"

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

TEST(LaboratoryLong, TableOneAsPrintedGivesThePrintedModulusAndAHigherStrength) {
  // printed: 27.8 GPa and 91.1 MPa. With Mohr-Coulomb friction of the right sign in the strength the printed cohesion
  // gives 123 to 146 MPa on Delaunay meshes of five seeds; this range with its scatter of 8 % is what is asked for
  for (const std::uint64_t seed : {1, 2}) {
    const PlatenResult r = load_between_platens(Exec(), specimen(), profile(95e6, seed), {});
    EXPECT_NEAR(r.modulus, 27.8e9, 0.03 * 27.8e9);
    EXPECT_NEAR(r.poisson, 0.237, 0.02);
    EXPECT_GT(r.strength, 113e6);
    EXPECT_LT(r.strength, 160e6);
  }
}

TEST(LaboratoryLong, SoakingLowersTheModulusByTheDissolvedShareAndTheStrengthByLess) {
  double modulus = 0, strength = 1e9;
  for (const double d_c : {0.0, 0.1, 0.2, 0.3}) {
    PlatenTest soaked;
    soaked.chemical_damage = d_c;
    const PlatenResult r = load_between_platens(Exec(), specimen(), profile(60e6, 1), soaked);
    if (d_c == 0) modulus = r.modulus;
    EXPECT_NEAR(r.modulus, (1 - d_c) * modulus, 0.005 * modulus);
    EXPECT_LT(r.strength, 1.02 * strength);  // f1 falls by 2 to 4 % from one to the next
    EXPECT_GT(r.strength, 0.8 * 91.1e6 * (1 - d_c));
    strength = r.strength;
  }
}

TEST(LaboratoryLong, PulledRockHasTheModulusOfPressedRock) {
  PlatenTest pull;
  pull.speed = -0.1;
  const PlatenResult r = load_between_platens(Exec(), specimen(), profile(60e6, 1), pull);
  EXPECT_NEAR(r.modulus, 27.8e9, 0.03 * 27.8e9);
  EXPECT_NEAR(r.strength, 10.5e6, 0.1 * 10.5e6);  // 0.70 of the mean bond strength of 15 MPa
  EXPECT_EQ(r.bonds_at_peak.failed_in_shear, 0);
}

}  // namespace
