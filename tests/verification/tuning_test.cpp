// Settings from a tolerance: what is promised of the chosen ones is found again by runs of their own.
#include "coupling/tuning.hpp"

#include "base/require.hpp"
#include "coupling/history_difference.hpp"
#include "io/override_scene.hpp"
#include "support/rows.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

using testing::ElementsAre;

const History truth{{"time_s", "a_J", "still_J", "count_1", "x_initial_J"},
                    {{0, 1, 2}, {5, 7, 9}, {3, 3, 3}, {0, 1, 2}, {0, 1, 2}}};

/// A rate at the start is that of the first step after a jump, however long that is: 4 of 1e8 would be nothing.
TEST(LargestDifference, OfRatesLeavesOutTheStart) {
  const auto flow = [](double first, double last) {
    return History{{"time_s", "left_heat_flow_W_per_m"}, {{0, 1, 2, 3}, {first, 10, 8, last}}};
  };
  EXPECT_NEAR(largest_difference(flow(1e8, 6), flow(5e7, 6.04), {"left_heat_flow_W_per_m"}, 0).value, 0.01, 1e-12);
}

TEST(LargestDifference, IsOverTheChangeOfItsColumn) {
  History other = truth;
  other.values[1][1] += 0.02;  // of a change of 4
  other.values[2][1] += 100;   // of a column that does not change
  other.values[3][1] += 100;   // a count
  other.values[4][1] += 100;   // a part of a balance
  const Difference found = largest_difference(truth, other, {});
  EXPECT_NEAR(found.value, 0.005, 1e-15);
  EXPECT_EQ(found.column, "a_J");
  EXPECT_NEAR(largest_difference(truth, other, {"count_1"}).value, 50, 1e-12);
  EXPECT_THROW(largest_difference(truth, other, {"b_J"}), InputError);
  other.names.insert(other.names.begin() + 1, "awake_1");  // of a setting that has a column of its own
  other.values.insert(other.values.begin() + 1, std::vector<double>{1, 1, 1});
  EXPECT_NEAR(largest_difference(truth, other, {}).value, 0.005, 1e-15);
  other.values[2][2] = NAN;
  EXPECT_EQ(largest_difference(truth, other, {}).value, INFINITY);
}

const History flows{{"time_s", "largest_mach_1", "mean_velocity_x_m/s", "mean_velocity_y_m/s"},
                    {{0, 1, 2}, {0, 0.1, 0.1}, {0, 1, 2}, {0, 0.1, 0.2}}};

/// Of a vector, both components are divided by the larger change.
TEST(LargestDifference, OfAMeanVelocityIsOverItsLargerComponent) {
  History other = flows;
  other.values[3][1] += 0.01;
  EXPECT_NEAR(largest_difference(flows, other, {}).value, 0.005, 1e-15);
  EXPECT_EQ(largest_difference(flows, other, {}).column, "mean_velocity_y_m/s");
}

/// Across a symmetric channel, and in a closed cavity, the mean velocity is rounding.
TEST(LargestDifference, LeavesOutAMeanVelocityThatIsRounding) {
  History across = flows;
  across.values[3] = {0, 1e-18, -2e-18};
  History other = across;
  other.values[3] = {0, 1e-8, 1e-8};
  EXPECT_EQ(largest_difference(across, other, {}).value, 0);
  EXPECT_EQ(largest_difference(across, other, {"mean_velocity_y_m/s"}).value, 0);
  const double sound = speed_of_sound({.spacing = 2, .time_step = 0.5});
  EXPECT_NEAR(sound, 4 / std::sqrt(3.0), 1e-15);
  History cavity = across;
  cavity.values[2] = {0, 3e-18, 1e-18};
  EXPECT_EQ(largest_difference(cavity, other, {}, sound).value, 0);
  EXPECT_GT(largest_difference(cavity, other, {"mean_velocity_x_m/s"}, sound).value, 1) << "it is requested";
}

/// Acid that diffuses to a slab and dissolves it, warm: slow enough for every interval to have its price.
Scene slab() {
  return parse_scene(
      "[lattice]\nsize = [24, 8]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 1600\n"
      "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [16, 0]\nto = [24, 8]\n"
      "[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.2\ninitial_temperature = 300\n"
      "[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\ninitial = 1\n"
      "[reaction]\nreactant = \"A\"\nrate_constant = 0.05\nmolar_volume = 0.02\nactivation_energy = 3e4\n"
      "reference_temperature = 300\n"
      "[boundary.left]\nheat = { type = \"temperature\", temperature = [[0, 300], [400, 330]] }\n"
      "solute = { type = \"concentration\", concentration = { A = 1 } }\n",
      "slab.toml");
}

History run(const Scene& scene, int steps) {
  return test::rows_of(scene, steps, 80);
}

Scene with(const Tuning& tuning, bool finest) {
  std::vector<std::string> keys;
  for (const TunedSetting& tuned : tuning.settings)
    keys.push_back(tuned.setting.key + "=" + tuned.setting.rungs[finest ? 0 : tuned.chosen]);
  return override_scene(slab(), keys);
}

TEST(Tuning, KeepsItsToleranceInARunOfItsOwnAndGrowsWithIt) {
  std::size_t before = 0;
  for (const double tolerance : {1e-4, 1e-2}) {
    TuningOptions options;
    options.tolerance = tolerance;
    options.steps = 800;
    const Tuning tuning = tune(slab(), options);
    EXPECT_LE(tuning.error, tolerance);
    EXPECT_GT(tuning.error, 0) << "something was given up";
    const Difference found = largest_difference(run(with(tuning, true), 800), run(with(tuning, false), 800), {});
    EXPECT_NEAR(found.value, tuning.error, 0.5 * tuning.error) << "the rows are not all the same";
    // the whole run, of which the pilots saw the first half
    EXPECT_LE(largest_difference(run(with(tuning, true), 1600), run(with(tuning, false), 1600), {}).value, tolerance);
    std::size_t rungs = 0;
    for (const TunedSetting& tuned : tuning.settings) rungs += tuned.chosen;
    EXPECT_GT(rungs, before) << "coarser settings for " << tolerance;
    before = rungs;
    std::printf("    tolerance %g: error %.1e, cost %.2f of the finest settings, %d pilots\n", tolerance, tuning.error,
                tuning.cost, tuning.pilots);
  }
}

/// Nothing flows across a channel with a block in its middle.
TEST(Tuning, IsNotJudgedByRounding) {
  const Scene scene = parse_scene(
      "[lattice]\nsize = [48, 16]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 400\n"
      "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [20, 4]\nto = [28, 12]\n"
      "[flow]\nviscosity = 0.1\ndensity = 1\ninitial_pressure = 0\n"
      "[boundary.left]\nflow = { type = \"velocity\", velocity = [0.02, 0] }\n"
      "[boundary.right]\nflow = { type = \"pressure\", pressure = 0 }\n",
      "channel.toml");
  const Tuning tuning = tune(scene, {});
  EXPECT_EQ(tuning.settings.at(0).setting.rungs[tuning.settings[0].chosen], "\"single\"");
  EXPECT_LT(tuning.error, 1e-3);
}

TEST(Tuning, OfNoToleranceIsTheFinestSettings) {
  TuningOptions options;
  options.tolerance = 1e-300;
  options.steps = 200;
  const Tuning tuning = tune(slab(), options);
  EXPECT_EQ(tuning.error, 0) << "the same bits";
  for (const TunedSetting& tuned : tuning.settings) EXPECT_EQ(tuned.chosen, 0u) << tuned.setting.key;
}

/// Heat that does not move is the same in any interval: nothing is known of it, and nothing chosen.
TEST(Tuning, LeavesAloneWhatNoColumnShows) {
  TuningOptions options;
  options.steps = 200;
  options.columns = {"dissolved_volume_m3_per_m"};
  const Tuning tuning = tune(override_scene(slab(), {"boundary.left.heat.temperature=300"}), options);
  EXPECT_FALSE(tuning.settings[1].seen) << tuning.settings[1].setting.key;
  EXPECT_TRUE(tuning.settings[2].seen) << tuning.settings[2].setting.key;
  const std::string text = to_text(tuning, options.tolerance);
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("\nheat_interval")));
  EXPECT_THAT(text, testing::HasSubstr("\nsolute_interval"));
}

/// Pilots have the intervals of their rungs, not longest ones: a tolerance in the case changes nothing but the case.
TEST(Tuning, OfACaseWithAToleranceIsThatWithout) {
  TuningOptions options;
  options.tolerance = 1e-2;
  options.steps = 400;
  const Tuning without = tune(slab(), options);
  const Tuning with = tune(override_scene(slab(), {"accuracy.tolerance=1e-2", "accuracy.preset=\"careful\""}), options);
  EXPECT_EQ(with.error, without.error);
  for (std::size_t s = 0; s < with.settings.size(); ++s)
    EXPECT_EQ(with.settings[s].chosen, without.settings[s].chosen) << with.settings[s].setting.key;
  EXPECT_LT(with.error_of_case, 1e-2) << "chosen as it goes";
}

/// An interval that is no divisor of 40 is compared where it ends: 7 costs no more than 8, which is one.
TEST(Tuning, ComparesTheCaseWhereItsOwnIntervalsEnd) {
  const auto tuned = [](const std::string& set) {
    TuningOptions options;
    options.tolerance = 1e-300;  // pilots of the first rungs only
    options.steps = 400;
    options.columns = {"heat_stored_J_per_m"};
    return tune(override_scene(slab(), {"accuracy.update_interval=1", set}), options);
  };
  const Tuning seven = tuned("accuracy.heat_interval=7"), eight = tuned("accuracy.heat_interval=8");
  std::printf("    heat_interval 7: %.1e, 8: %.1e\n", seven.error_of_case, eight.error_of_case);
  EXPECT_LT(seven.error_of_case, 1.2 * eight.error_of_case);
  EXPECT_GT(seven.error_of_case, 0.5 * eight.error_of_case);
  EXPECT_EQ(seven.pilots, eight.pilots + 1);
  EXPECT_GT(seven.cost_of_case, 0);
}

TEST(Tuning, KnowsTheSettingsOfTheModulesThereAre) {
  std::vector<std::string> keys;
  for (const Setting& setting : settings_of(slab())) keys.push_back(setting.key);
  EXPECT_THAT(keys, ElementsAre("accuracy.precision", "accuracy.heat_interval", "accuracy.solute_interval",
                                "accuracy.update_interval", "accuracy.wall_interval"));
}

}  // namespace
}  // namespace vug
