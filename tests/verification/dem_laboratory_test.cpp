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

}  // namespace
