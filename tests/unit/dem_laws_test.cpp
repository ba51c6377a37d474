#include "dem/bond_law.hpp"
#include "dem/contact_law.hpp"
#include "dem/dissolved_rock.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace {

using namespace vug;

TEST(ChemicalDamage, FunctionsAreThePapersWithAHeldEnergy) {
  const ChemicalFactors raw(ChemicalDamageLaw{.normalised = false}), normalised(ChemicalDamageLaw{});
  EXPECT_DOUBLE_EQ(raw.strength(0), 0.98);
  EXPECT_DOUBLE_EQ(raw.energy(0), 1.01);
  EXPECT_DOUBLE_EQ(normalised.strength(0), 1);
  EXPECT_DOUBLE_EQ(normalised.energy(0), 1);
  EXPECT_NEAR(raw.strength(0.3), 0.9104, 1e-12);
  EXPECT_NEAR(raw.energy(0.3), 0.4841, 1e-12);
  EXPECT_NEAR(raw.energy(1), 0.4828, 1e-4);  // the minimum, not 2.96
  constexpr double turning = 3.34 / (2 * 5.29);
  for (double d = 0; d <= 1; d += 1.0 / 64) {  // every bit of the fits as printed
    const double held = d < turning ? d : turning;
    EXPECT_EQ(normalised.strength(d), ((-0.83 * d + 0.017) * d + 0.98) / 0.98) << d;
    EXPECT_EQ(normalised.energy(d), ((5.29 * held - 3.34) * held + 1.01) / 1.01) << d;
  }
}

/// Values by hand: f1 = 2 - d, so that 1.5/2 is left at d = 0.5; f2 = 4 d^2 - 4 d + 2 with its minimum 1 at d = 0.5.
TEST(ChemicalDamage, FitsMayBeThoseOfAnotherRock) {
  const ChemicalDamageLaw law{.strength = {0, -1, 2}, .energy = {4, -4, 2}};
  const ChemicalFactors factors(law);
  EXPECT_DOUBLE_EQ(factors.strength(0.5), 0.75);
  EXPECT_DOUBLE_EQ(factors.strength(1), 0.5);
  EXPECT_DOUBLE_EQ(factors.energy(0.25), 0.625);
  EXPECT_DOUBLE_EQ(factors.energy(0.5), 0.5);
  EXPECT_DOUBLE_EQ(factors.energy(1), 0.5);                                  // constant beyond the minimum
  const ChemicalFactors falling(ChemicalDamageLaw{.energy = {1, -2.5, 2}});  // its minimum at 1.25 is outside
  EXPECT_DOUBLE_EQ(falling.energy(1), 0.25);
  const ChemicalFactors bent(ChemicalDamageLaw{.energy = {-1, 0, 2}});  // no minimum
  EXPECT_DOUBLE_EQ(bent.energy(1), 0.5);
}

/// Eqs. 12 and 26: d' = d_m + d_c - d_m d_c, and the modulus keeps 1 - d'; in compression d_c alone weakens it.
TEST(ComprehensiveDamage, LeavesItsShareOfTheModulus) {
  const double l = 2e-3, d_m = 0.4, d_c = 0.3;
  MechanicsParameters parameters;
  parameters.bond.weibull_shape = 0;
  const double length = 0.659 * 2 * (l * std::sqrt(3.0) / 2) / 3;  // a third of its height on either side
  for (const double opening : {1e-8, -1e-8}) {
    Mechanics rock(test::pair_of_triangles(l), parameters, {});
    Kokkos::deep_copy(rock.bonds().d_c, d_c);
    Kokkos::deep_copy(rock.bonds().point_damage, d_m);
    Kokkos::deep_copy(rock.bonds().d_m, d_m);
    test::place(rock.particles(), 1, opening, 2e-8);
    rock.advance(Exec(), 1e-12, 1);
    const auto stress = test::host_copy(rock.bonds().stress);
    const double share = 1 - (d_m + d_c - d_m * d_c);
    EXPECT_NEAR(stress(0, 0) / ((opening > 0 ? share : 1 - d_c) * 24.03e9 * opening / length), 1, 1e-9);
    EXPECT_NEAR(stress(0, 1) / (share * 10.68e9 * 2e-8 / length), 1, 1e-9);
  }
}

TEST(BondLaw, CompressionStrengthensShearAndTensionDoesNotWeakenIt) {
  EXPECT_DOUBLE_EQ(shear_strength(95e6, 0.47, -10e6), 99.7e6);
  EXPECT_DOUBLE_EQ(shear_strength(95e6, 0.47, 10e6), 95e6);
}

TEST(BondLaw, NeverDamagesByCompressionAlone) {
  const BondPoint p{3e13, 1.4e13, 15e6, 95e6, 20, 64};
  for (const double overlap : {1e-9, 1e-6, 1e-3}) EXPECT_EQ(damage_of_opening(p, -overlap, 0), 0);
}

TEST(BondLaw, DamageRisesWithTheOpeningUntilOne) {
  const BondPoint p{3e13, 1.4e13, 15e6, 95e6, 20, 64};
  double before = 0;
  for (double opening = 1e-8; opening < 5e-6; opening += 1e-8) {
    const double d = damage_of_opening(p, opening, 0.3 * opening);
    EXPECT_GE(d, before);
    EXPECT_LE(d, 1);
    before = d;
  }
  EXPECT_EQ(before, 1);
}

TEST(BondLaw, IsOverstressedWhereOpeningsDamage) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> opening(-2e-6, 2e-6), share(0, 1);
  int damaged = 0, sound = 0;
  for (int trial = 0; trial < 10000; ++trial) {
    const BondPoint p{3e13, 1.4e13, 15e6 * share(random), 95e6 * share(random), 20, 64};
    const double delta_n = opening(random), delta_t = 5 * opening(random);
    const double d = damage_of_opening(p, delta_n, delta_t);
    EXPECT_EQ(is_overstressed(p, delta_n, delta_t), d > 0) << delta_n << ' ' << delta_t;
    ++(d > 0 ? damaged : sound);
  }
  EXPECT_GT(damaged, 1000);
  EXPECT_GT(sound, 1000);
}

TEST(BondLaw, StaysFiniteAtTheExtremes) {
  for (const double strength : {0.0, 1e-30, 15e6, 1e30}) {
    for (const double energy : {0.0, 1e-30, 20.0, 1e30}) {
      for (const double k : {0.0, 1e-3, 3e13, 1e30}) {
        for (const double opening : {-1.0, 0.0, 1e-12, 1e-6, 1.0}) {
          const double d = damage_of_opening({k, k, strength, strength, energy, energy}, opening, opening);
          EXPECT_TRUE(d >= 0 && d <= 1) << strength << " " << energy << " " << k << " " << opening << ": " << d;
          EXPECT_TRUE(d == 0 || is_overstressed({k, k, strength, strength, energy, energy}, opening, opening))
              << strength << " " << k << " " << opening;
        }
      }
    }
  }
}

TEST(ContactLaw, NeverPullsAndRubsWithinCoulombsLimit) {
  const ContactPoint p{1e10, 5e9, 1e3, 0, 0.3};
  EXPECT_EQ(contact_reaction(p, -1e-6, 1, 1e-6, 0, 0).normal, 0);
  EXPECT_EQ(contact_reaction(p, 1e-9, -1e3, 0, 0, 0).normal, 0);  // parting fast: the dashpot would pull
  const ContactReaction stuck = contact_reaction(p, 1e-6, 0, 1e-7, 0, 0);
  EXPECT_DOUBLE_EQ(stuck.tangential, -500);
  EXPECT_EQ(stuck.slip, 0);
  const ContactReaction sliding = contact_reaction(p, 1e-6, 0, 1e-5, 0, 0);
  EXPECT_DOUBLE_EQ(sliding.tangential, -3000);
  EXPECT_NEAR(sliding.slip, 1e-5 - 3000 / 5e9, 1e-18);
}

TEST(DissolvedRock, ShareThatRemainsFallsOnly) {
  EXPECT_DOUBLE_EQ(remaining_share(0.8, 0.5, 2.0), 0.6);
  EXPECT_EQ(remaining_share(0.8, 2.0, 2.0), 0);
  EXPECT_EQ(remaining_share(0.8, 2.1, 2.0), 0);
  EXPECT_EQ(remaining_share(1.0, -1e-16, 0.5), 1.0);  // by rounding: 1 + 2e-16 would be no share
  EXPECT_EQ(remaining_share(0.8, 0.0, 0.0), 0.8);     // nodes that hold nothing lose nothing
}

}  // namespace
