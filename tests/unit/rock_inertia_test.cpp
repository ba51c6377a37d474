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

/// Whatever its load: its weight starts to move it at once.
TEST(RockInertia, RockThatFallsHasItsOwnMass) {
  const auto chosen = [](const std::string& more, const std::vector<std::string>& set) {
    return parse_scene(
               "[lattice]\nsize = [0.04, 0.04]\nspacing = 1e-3\ntime_step = 1e-6\n[time]\nsteps = 10\n"
               "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 4e-3\n[mechanics]\n" +
                   more + "[accuracy]\ntolerance = 1e-2\n",
               "a.toml", set)
        .mechanics->parameters.mass_scaling;
  };
  EXPECT_EQ(chosen("gravity = [0, -9.81]\n", {}), 1);
  EXPECT_EQ(chosen("gravity = [0, -9.81]\n", {"boundary.bottom.traction.support=\"fixed\""}), 64);
  EXPECT_EQ(chosen("gravity = [0, -9.81]\n", {"boundary.top.traction.support=\"roller\"",
                                              "rock.notches=[{ from = [0, 0.02], to = [0.04, 0.02], aperture = 0 }]"}),
            1)
      << "what is below the notch";
  EXPECT_EQ(chosen("", {}), 64) << "nothing moves it";
}

/// A wave of 3060 m/s crosses 12 cm in 39 microseconds; bending takes 12 times as long as the rock is slender.
TEST(RockInertia, SlenderRockBendsLate) {
  const auto chosen = [](const std::string& height) {
    return parse_scene("[lattice]\nsize = [0.12, " + height +
                           "]\nspacing = 1e-3\ntime_step = 1e-6\n[time]\nsteps = 10\n"
                           "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 2e-3\n[mechanics]\n"
                           "[boundary.left]\ntraction = { support = \"fixed\" }\n[boundary.right]\ntraction = { "
                           "shear_stress = [[0, 0], [2e-2, 2e4]] }\n[accuracy]\ntolerance = 5e-3\n",
                       "a.toml")
        .mechanics->parameters.mass_scaling;
  };
  EXPECT_EQ(chosen("0.06"), 64);
  EXPECT_EQ(chosen("0.02"), 4);
  EXPECT_EQ(chosen("0.01"), 1);
}

/// A block of 4 cm, which a wave crosses in 13 microseconds; 6 t times 10 ms are 60 microseconds.
TEST(RockInertia, OfABlockThatIsPressedIsChosenByItsLoadAndItsSprings) {
  const auto chosen = [](const std::string& end, const std::string& held) {
    return parse_scene(
               "[lattice]\nsize = [0.04, 0.04]\nspacing = 1e-3\ntime_step = 1e-6\n[time]\nsteps = 10\n"
               "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 4e-3\n[mechanics]\n[accuracy]\n"
               "tolerance = 1e-3\n[boundary.left]\ntraction = { " +
                   held + " }\n[boundary.right]\ntraction = { normal_stress = [[0, 0], [" + end + ", 1e6]] }\n",
               "a.toml", {})
        .mechanics->parameters.mass_scaling;
  };
  EXPECT_EQ(chosen("1e-2", "support = \"roller\""), 16) << "4.6 times slower";
  EXPECT_EQ(chosen("1e-3", "support = \"roller\""), 1) << "0.46 times: not the fourfold mass of `fast`";
  EXPECT_EQ(chosen("1e-2", "stiffness = 1e9"), 1) << "on the springs it swings in 316 microseconds";
  EXPECT_EQ(chosen("1e-2", "stiffness = 1e14"), 16) << "in 1 microsecond";
}

/// Its momentum is that of its own mass.
TEST(RockInertia, OfThrownRockIsItsOwn) {
  const Scene scene = parse_scene(
      "[lattice]\nsize = [0.04, 0.04]\nspacing = 1e-3\ntime_step = 1e-6\n[time]\nsteps = 10\n[geometry]\ntype = "
      "\"rock\"\n[rock]\nelement_size = 4e-3\n[mechanics]\n[accuracy]\ntolerance = 1e-3\n"
      "[[mechanics.initial_velocity]]\ntype = \"rectangle\"\nfrom = [0, 0]\nto = [0.04, 0.04]\nvelocity = [0.1, 0]\n",
      "a.toml", {});
  EXPECT_EQ(scene.mechanics->parameters.mass_scaling, 1);
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
