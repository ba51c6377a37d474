// The press itself: when a test ends and what it says.
#include "base/require.hpp"
#include "dem/laboratory.hpp"
#include "dem/materials.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace vug;

TEST(Laboratory, SmallSpecimenBreaksAndSaysSo) {
  MechanicsParameters parameters;
  parameters.bond.cohesion = 60e6;
  PlatenTest test;
  test.speed = 2;
  std::vector<double> pressed;  // by the platens over the width, at every sample
  const PlatenResult r = load_between_platens(
      Exec(), test::block(0.015, 0.03, 2.5e-3, 0.2), parameters, test,
      [&](const Mechanics& rock, const PlatenResult&, bool) {
        pressed.push_back(0.5 * (rock.reaction(RockSide::bottom).y - rock.reaction(RockSide::top).y) / 0.015);
      });
  EXPECT_GT(r.bonds_at_end.failed(), r.bonds_at_peak.failed());
  EXPECT_GT(r.strength, 60e6);
  EXPECT_LT(r.strength, 150e6);
  ASSERT_EQ(pressed.size(), r.stress.size());
  std::size_t peak = 0;
  for (std::size_t k = 0; k < pressed.size(); ++k) {
    EXPECT_NEAR(r.stress[k], pressed[k], 1e-9 * r.strength) << k;
    if (pressed[k] > pressed[peak]) peak = k;
  }
  EXPECT_NEAR(r.strength, pressed[peak], 1e-9 * r.strength);
  EXPECT_EQ(r.peak_strain, r.strain[peak]);
  EXPECT_LT(r.stress.back(), 0.6 * r.strength);
}

/// Bonds without strength fail as soon as they are pulled: rock that never bears anything has been tested.
TEST(Laboratory, EndsWhenRockWithoutStrengthIsPulled) {
  MechanicsParameters parameters;
  parameters.bond.normal_strength = 0;
  PlatenTest test;
  test.speed = -0.5;
  const PlatenResult r = load_between_platens(Exec(), test::block(0.015, 0.03, 2.5e-3, 0.2), parameters, test);
  EXPECT_LT(r.strength, 1e-3 * 15e6);
  EXPECT_LT(r.strain.back(), 0.1 * test.largest_strain);
  EXPECT_GT(broken(r.bonds_at_end), 0);
  EXPECT_TRUE(r.passed_a_peak());
}

TEST(Laboratory, RefusesAServoWithoutAPressureToHold) {
  PlatenTest test;
  test.flanks = Support::servo;
  EXPECT_THROW(load_between_platens(Exec(), test::block(0.015, 0.03, 2.5e-3, 0.2), {}, test), InputError);
}

/// Rock that breaks as it warms between platens, to a millistrain of growth.
PlatenResult heated(double sample_strain, const Assembly& specimen, MechanicsParameters parameters = {}) {
  parameters.local_damping = 0.1;
  parameters.bond.cohesion = 40e6;
  PlatenTest test;
  test.speed = 0;
  test.heating_rate = 500 / 2e-4;
  test.largest_strain = 8e-6 * 500;
  test.sample_strain = sample_strain;
  test.stop_below = -1e9;  // goes on to the end
  return load_between_platens(Exec(), specimen, parameters, test);
}

/// Every step adds its share of the heat, whatever is written down.
TEST(LaboratoryHeating, BreaksTheSameBondsHoweverOftenItIsLookedAt) {
  const Assembly specimen = test::block(0.012, 0.024, 2.4e-3, 0.2);
  const PlatenResult fine = heated(1e-5, specimen);
  EXPECT_GT(fine.bonds_at_end.failed(), 10);
  for (const double sample : {6e-4, 4e-3}) {
    const PlatenResult coarse = heated(sample, specimen);
    EXPECT_EQ(coarse.bonds_at_end.failed(), fine.bonds_at_end.failed()) << sample;
    EXPECT_EQ(coarse.stress.back(), fine.stress.back()) << sample;
    EXPECT_EQ(coarse.steps, fine.steps) << sample;
  }
}

TEST(LaboratoryHeating, EndsAtItsEnd) {
  const Assembly specimen = test::block(0.012, 0.024, 2.4e-3, 0.2);
  for (const double sample : {3e-4, 8e-6 * 500}) {  // 13.3 samples, and one
    double warmest = 0;
    MechanicsParameters parameters;
    parameters.local_damping = 0.1;
    PlatenTest test;
    test.speed = 0;
    test.heating_rate = 500 / 2e-4;
    test.largest_strain = 8e-6 * 500;
    test.sample_strain = sample;
    test.stop_below = -1e9;
    const PlatenResult r =
        load_between_platens(Exec(), specimen, parameters, test, [&](const Mechanics& rock, const PlatenResult&, bool) {
          warmest = vug::test::host_copy(rock.particles().temperature_change)(0);
        });
    EXPECT_NEAR(warmest, 500, 1e-9 * 500) << sample;
    EXPECT_NEAR(r.strain.back(), 8e-6 * 500, 1e-12) << sample;
    EXPECT_NEAR(static_cast<double>(r.steps) * r.time_step, 2e-4, r.time_step) << sample;
  }
}

/// Half of the rock grows, that is not the base: its strain is that of the mean.
TEST(LaboratoryHeating, OfSeveralMaterialsStrainsByTheMeanOfTheirExpansions) {
  Assembly specimen = test::block(0.012, 0.024, 2.4e-3, 0);
  double area = 0, grows = 0;
  for (std::size_t t = 0; t < specimen.triangles.size(); ++t) {
    specimen.region.push_back(t % 2 == 0 ? 0 : 1);
    const double own = triangle_of(specimen, static_cast<int>(t)).area();
    area += own, grows += t % 2 == 0 ? 0 : own;
  }
  MechanicsParameters parameters = test::elastic(0.1);
  parameters.thermal_expansion = 0;
  parameters.materials = {{2500, 1e-5, parameters.bond}};
  const double mean = 1e-5 * grows / area;
  EXPECT_NEAR(mean_expansion(parameters, specimen), mean, 1e-12 * mean);
  PlatenTest test;
  test.speed = 0;
  test.heating_rate = 100 / 2e-4;
  test.largest_strain = mean * 100;
  const PlatenResult r = load_between_platens(Exec(), specimen, parameters, test);
  EXPECT_NEAR(static_cast<double>(r.steps) * r.time_step, 2e-4, r.time_step);
  EXPECT_NEAR(r.strain.back(), mean * 100, 1e-12);
  // as rock that has the mean throughout, to what the grains do to each other
  parameters.materials.clear();
  specimen.region.clear();
  parameters.thermal_expansion = mean;
  const PlatenResult even = load_between_platens(Exec(), specimen, parameters, test);
  EXPECT_NEAR(r.stress.back(), even.stress.back(), 0.05 * even.stress.back());
}

/// The confinement is there from the first sample on, also where it was asked for at once.
TEST(Laboratory, RestsUnderItsConfinementBeforeTheTest) {
  const auto stress = [](double time) {
    PlatenTest test;
    test.confinement = 20e6;
    test.confining_time = time;
    test.largest_strain = 4e-4;
    test.speed = 0.5;
    return load_between_platens(Exec(), test::block(0.012, 0.024, 2.4e-3, 0.2), test::elastic(), test);
  };
  const PlatenResult slowly = stress(150e-6), at_once = stress(0);
  ASSERT_TRUE(at_once.preload);
  EXPECT_TRUE(at_once.preload->settled);
  ASSERT_EQ(at_once.stress.size(), slowly.stress.size());
  for (std::size_t k = 0; k < slowly.stress.size(); ++k)
    EXPECT_NEAR(at_once.stress[k], slowly.stress[k], 1e-3 * 20e6) << k;
}

}  // namespace
