// The press itself: when a test ends and what it says.
#include "dem/laboratory.hpp"
#include "dem_support.hpp"
#include "kernels/require.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace vug;

TEST(Laboratory, SmallSpecimenBreaksAndSaysSo) {
  MechanicsParameters parameters;
  parameters.bond.cohesion = 60e6;
  PlatenTest test;
  test.speed = 2;
  const PlatenResult r = load_between_platens(Exec(), test::block(0.015, 0.03, 2.5e-3, 0.2), parameters, test);
  EXPECT_GT(r.bonds_at_end.failed(), r.bonds_at_peak.failed());
  EXPECT_GT(r.strength, 60e6);
  EXPECT_LT(r.strength, 150e6);
  EXPECT_NEAR(r.strength, *std::max_element(r.stress.begin(), r.stress.end()), 0);
  EXPECT_LT(r.stress.back(), 0.6 * r.strength);
}

TEST(Laboratory, RefusesAServoWithoutAPressureToHold) {
  PlatenTest test;
  test.flanks = Support::servo;
  EXPECT_THROW(load_between_platens(Exec(), test::block(0.015, 0.03, 2.5e-3, 0.2), {}, test), InputError);
}

}  // namespace
