// The press itself: when a test ends and what it says.
#include "dem/laboratory.hpp"
#include "dem_support.hpp"
#include "kernels/base/require.hpp"

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

TEST(Laboratory, RefusesAServoWithoutAPressureToHold) {
  PlatenTest test;
  test.flanks = Support::servo;
  EXPECT_THROW(load_between_platens(Exec(), test::block(0.015, 0.03, 2.5e-3, 0.2), {}, test), InputError);
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
