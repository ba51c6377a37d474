// How heavy rock may be made under loads that change slowly.
#include "io/rock_inertia.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace vug {
namespace {

/// Waves of 3100 m/s cross its 10 cm in 32 microseconds.
Scene acid(const std::vector<std::string>& overrides = {}) {
  return read_scene(VUG_SOURCE_DIR "/cases/acid_fracturing/coarse/p30_da1.5e-3.toml", overrides);
}
MechanicsSection rock_of(const std::vector<std::string>& overrides) {
  return *acid(overrides).mechanics;
}

TEST(TimeTables, TellTheirQuickestChange) {
  EXPECT_EQ(TimeTable(3).quickest(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(TimeTable({0, 1, 1.5, 4}, {2, 2, 3, 7}).quickest(), 0.5);
  EXPECT_EQ(TimeTable({0, 1, 3}, {2, 2, 3}).quickest(), 2) << "nothing changes before";
}

TEST(RockInertia, KnowsTheQuickestLoad) {
  EXPECT_EQ(quickest_load(acid()), 5e-3) << "the ramp of the pressure";
  const std::string ramp = "boundary.injection.flow.ramp_time=";
  EXPECT_DOUBLE_EQ(quickest_load(acid({ramp + "1"})), 6e-3 * 6e-3 / 3.5e-3) << "heat through a triangle";
  EXPECT_EQ(quickest_load(acid({ramp + "0"})), 0) << "a pressure at once";
  EXPECT_EQ(quickest_load(acid({"boundary.top.traction.normal_stress=[[0, 7.5e6], [2e-3, 8e6]]"})), 2e-3);
  EXPECT_EQ(
      quickest_load(acid({"boundary.left.traction.velocity=[1e-3, 0]", "boundary.left.traction.support=\"fixed\""})),
      0);
}

TEST(RockInertia, ATolerancePicksTheLargestMassThatFollows) {
  EXPECT_EQ(rock_of({"accuracy.tolerance=1e-2"}).parameters.mass_scaling, 64);
  EXPECT_TRUE(rock_of({"accuracy.tolerance=1e-2"}).scaling_chosen);
  EXPECT_EQ(rock_of({"accuracy.tolerance=5e-3"}).parameters.mass_scaling, 16) << "waves may be 4.6 times slower";
  EXPECT_EQ(rock_of({"accuracy.tolerance=1e-3", "accuracy.preset=\"fast\""}).parameters.mass_scaling, 4)
      << "its preset's";
  EXPECT_EQ(rock_of({"accuracy.tolerance=1e-2", "mechanics.mass_scaling=2"}).parameters.mass_scaling, 2);
  EXPECT_FALSE(rock_of({"accuracy.tolerance=1e-2", "mechanics.mass_scaling=2"}).scaling_chosen);
  EXPECT_EQ(rock_of({"accuracy.tolerance=1e-2", "boundary.injection.flow.ramp_time=0"}).parameters.mass_scaling, 1);
  EXPECT_EQ(rock_of({"accuracy.tolerance=1e-2", "mechanics.density=10000"}).parameters.mass_scaling, 16);
  EXPECT_EQ(rock_of({"accuracy.tolerance=1e-2", "mechanics.substeps=20"}).parameters.mass_scaling, 1);
}

}  // namespace
}  // namespace vug
