// What is refused and what is said of intervals that leave out something of a case.
#include "coupling/interval_warnings.hpp"

#include "base/require.hpp"
#include "coupling/check.hpp"
#include "support/obstacle.hpp"
#include "support/run_vug.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::obstacle;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> warnings(const std::vector<std::string>& set, const std::string& text = obstacle) {
  return interval_warnings(parse_scene(text, "a.toml", set));
}

std::string refusal(const std::vector<std::string>& set, const std::string& text = obstacle) {
  try {
    parse_scene(text, "a.toml", set);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string dissolving = obstacle + "[reaction]\nreactant = \"A\"\nrate_constant = 1e-3\nmolar_volume = 1e-3\n";

/// Rock in a channel, pushed by the fluid.
const std::string pushed =
    "[lattice]\nsize = [0.012, 0.008]\nspacing = 5e-4\ntime_step = 2e-6\n[time]\nsteps = 100\n"
    "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 3e-3\nporosity = 0\n"
    "[rock.hole]\nfrom = [0, 0.002]\nto = [0.004, 0.006]\n"
    "[flow]\ndensity = 1000\nviscosity = 1.25e-2\ninitial_pressure = 0\n[mechanics]\n"
    "[boundary.left]\ntraction = { support = \"fixed\" }\n"
    "[boundary.injection]\nside = \"left\"\ncentre = 0.004\nwidth = 0.004\n"
    "flow = { type = \"pressure\", pressure = 10 }\n";

TEST(IntervalsLongerThanTheRun, AreRefusedWhereTheCaseGivesThem) {
  EXPECT_THAT(refusal({"time.steps=500", "accuracy.heat_interval=501"}),
              HasSubstr("accuracy.heat_interval = 501 is more than the whole run, 500 steps: no temperature"));
  EXPECT_EQ(refusal({"time.steps=500", "accuracy.heat_interval=500"}), "") << "a step at the end";
  EXPECT_THAT(refusal({"time.steps=5", "accuracy.solute_interval=6"}), HasSubstr("no concentration would change"));
  EXPECT_THAT(refusal({"time.steps=5", "accuracy.exchange_interval=6"}, pushed), HasSubstr("bear the force"));
  EXPECT_EQ(refusal({"time.steps=5", "accuracy.exchange_interval=6"}), "") << "there is no rock that it pushes";
  EXPECT_EQ(refusal({"time.steps=5", "accuracy.heat_interval=600", "accuracy.tolerance=1e-3"}), "") << "the longest";
}

/// Those of a preset, and looks at the rock that one may not want.
TEST(IntervalsLongerThanTheRun, AreWarnedOfWhereAPresetSetsThem) {
  const std::string few = "time.steps=3", fast = "accuracy.preset=\"fast\"";
  EXPECT_EQ(refusal({few, fast}), "");
  EXPECT_THAT(warnings({few, fast}), ElementsAre(AllOf(HasSubstr("accuracy.heat_interval = 4 is more than the whole "
                                                                 "run, 3 steps: no temperature changes in it"))));
  EXPECT_THAT(warnings({"time.steps=4", fast}), IsEmpty());
  EXPECT_THAT(warnings({"accuracy.update_interval=1001"}, dissolving),
              ElementsAre(HasSubstr("accuracy.update_interval = 1001 is more than the whole run, 1000 steps: no node "
                                    "dissolves")));
  EXPECT_THAT(warnings({"accuracy.update_interval=1001"}), IsEmpty()) << "nothing can dissolve";
}

/// A trial of a few steps needs no other intervals.
TEST(IntervalsLongerThanTheRun, AreNotThoseOfATrial) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.toml";
  test::write_text(path, obstacle + "[accuracy]\nheat_interval = 100\n");
  const test::Outcome trial = test::run_vug("run " + path + " --steps 10 -o " + (folder / "out"));
  EXPECT_EQ(trial.exit_code, 0) << trial.output;
  EXPECT_EQ(test::run_vug("run " + path + " --set time.steps=10 -o " + (folder / "other")).exit_code, 2);
}

TEST(OldRows, AreWarnedOfWhereTheyAreMoreFrequentThanSteps) {
  EXPECT_THAT(
      warnings({"accuracy.heat_interval=4", "output.history_interval=2"}),
      ElementsAre("output.history_interval is 2 lattice steps, accuracy.heat_interval 4: temperatures are shown "
                  "as they were up to 3 steps before; raise the one or lower the other"));
  EXPECT_THAT(warnings({"accuracy.solute_interval=4", "output.interval_steps=3", "output.history_interval=8"}),
              ElementsAre(HasSubstr("output.interval_steps is 3 lattice steps, accuracy.solute_interval 4: conc")));
  EXPECT_THAT(warnings({"accuracy.heat_interval=4", "output.history_interval=4", "output.interval=4"}), IsEmpty());
  EXPECT_THAT(warnings({"output.history_interval=1"}), IsEmpty());
}

/// A row every 100 steps, or the 400th part of the run where that is longer.
TEST(OldRows, AreWarnedOfWhereTheyComeByDefault) {
  EXPECT_THAT(warnings({"accuracy.heat_interval=128"}),
              ElementsAre("output.history_interval is 100 lattice steps by default, accuracy.heat_interval 128: "
                          "temperatures are shown as they were up to 127 steps before; raise the one or lower the "
                          "other"));
  EXPECT_THAT(warnings({"accuracy.heat_interval=100", "accuracy.solute_interval=100"}), IsEmpty());
  const std::string longer = "time.steps=80000";  // a row every 200 steps
  EXPECT_THAT(warnings({"accuracy.heat_interval=200", longer}), IsEmpty());
  EXPECT_THAT(warnings({"accuracy.solute_interval=201", longer}), ElementsAre(HasSubstr("201: concentrations are")));
  EXPECT_THAT(warnings({"accuracy.heat_interval=128", "output.history_interval=128"}), IsEmpty());
}

TEST(Pulses, AreWarnedOfWhereAnIntervalIsLonger) {
  const std::string pulses = "boundary.injection.flow.pressure=[[0, 10], [2e-5, 20]]",
                    ten = "accuracy.exchange_interval=10";
  EXPECT_THAT(warnings({pulses, ten}, pushed), IsEmpty()) << "just as long";
  EXPECT_THAT(
      warnings({pulses, "accuracy.exchange_interval=11"}, pushed),
      ElementsAre(AllOf(HasSubstr("a given flow changes within 2e-05 s, accuracy.exchange_interval is 2.2e-05 s "
                                  "(11 steps): the force at the first step"))));
  EXPECT_THAT(warnings({"boundary.injection.flow.ramp_time=1e-5", ten}, pushed),
              ElementsAre(HasSubstr("within 1e-05")));
  EXPECT_THAT(warnings({ten}, pushed), IsEmpty());
  EXPECT_THAT(warnings({"boundary.left.flow.velocity=[[0, 0.01, 0], [3, 0, 0]]", "accuracy.solute_interval=4"}),
              ElementsAre(HasSubstr("accuracy.solute_interval is 4 s (4 steps): the velocity at one step")));
}

/// Every table of a flow, and the ramp; infinity where nothing changes.
TEST(Pulses, AreThoseOfEveryKindOfFlow) {
  Scene scene;
  EXPECT_EQ(quickest_flow(scene), std::numeric_limits<double>::infinity());
  scene.top.flow.pressure = TimeTable({0, 9}, {1, 2});
  EXPECT_EQ(quickest_flow(scene), 9);
  scene.left.flow.velocity[1] = TimeTable({0, 8}, {1, 2});
  EXPECT_EQ(quickest_flow(scene), 8);
  scene.openings.resize(1);
  scene.openings[0].conditions.flow.speed = TimeTable({0, 7}, {1, 2});
  EXPECT_EQ(quickest_flow(scene), 7);
  scene.injections.resize(1);
  scene.injections[0].conditions.flow.flow_rate = TimeTable({0, 6}, {1, 2});
  EXPECT_EQ(quickest_flow(scene), 6);
  scene.injections[0].conditions.flow.mass_flow_rate = TimeTable({0, 5}, {1, 2});
  EXPECT_EQ(quickest_flow(scene), 5);
  scene.right.flow.ramp_time = 4;
  EXPECT_EQ(quickest_flow(scene), 4);
}

/// 9973 and 997 have no common divisor: looks come every 9973 997 steps.
TEST(LooksAtAgeingRock, AreWarnedOfWhereTheyAreRare) {
  const std::string slow =
      "[lattice]\nsize = [24, 8]\nspacing = 1\ntime_step = 1\n[time]\nend = 1e9\n[geometry]\ntype = \"shapes\"\n"
      "[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [16, 0]\nto = [24, 8]\n"
      "[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = 1e-4\ninitial = 1\n"
      "[reaction]\nreactant = \"A\"\nrate_constant = 0.05\nmolar_volume = 0.02\n"
      "[accuracy]\ndissolution_tolerance = 1e-2\n";
  const auto of = [&](int update, int solute) {
    return warnings(
        {"accuracy.update_interval=" + std::to_string(update), "accuracy.solute_interval=" + std::to_string(solute)},
        slow);
  };
  EXPECT_THAT(of(9973, 997), ElementsAre(AllOf(HasSubstr("looked at every 9943081 lattice steps only"),
                                               HasSubstr("let one of them be a multiple of the other"))));
  EXPECT_THAT(of(5000, 100), ElementsAre(AllOf(HasSubstr("every 5000 lattice"), HasSubstr("; lower them"))));
  EXPECT_THAT(of(1000, 100), IsEmpty());
  EXPECT_THAT(warnings({"accuracy.dissolution_tolerance=0", "accuracy.update_interval=5000"}, slow), IsEmpty());
}

/// They reach `vug check` and the log of a run.
TEST(IntervalWarnings, AreThoseOfCheck) {
  EXPECT_THAT(
      check_case(parse_scene(obstacle, "a.toml", {"accuracy.heat_interval=4", "output.history_interval=2"})).warnings,
      Contains(HasSubstr("temperatures are shown as they were")));
}

/// Steps of 1e-3 s: what a table does between two of them, but for jumps and ramps.
TEST(TablesOverTime, WithPulsesBetweenStepsAreWarnedOf) {
  const auto told = [](const std::string& rows) {
    return warnings({"boundary.left.flow={ type = \"pressure\", pressure = " + rows + " }"});
  };
  const double step = parse_scene(obstacle, "a.toml").lattice.time_step;
  const auto rows = [&](const std::vector<std::pair<double, double>>& points) {
    std::string text = "[";
    for (const auto& [steps, value] : points) text += fmt::format("[{}, {}], ", steps * step, value);
    return text + "]";
  };
  const auto pulse = [](const std::string& taken) {
    return ElementsAre(HasSubstr("of which lattice steps take " + taken + " times as much as there is"));
  };
  EXPECT_THAT(told(rows({{4.1, 1}, {4.3, 2}, {4.7, 2}, {4.9, 1}})), pulse("0"));
  EXPECT_THAT(told(rows({{4.1, 1}, {5.3, 2}, {6.1, 1}})), pulse("0.87")) << "in part";
  EXPECT_THAT(told(rows({{99.9, 1}, {100, 2}, {100.1, 1}})), pulse("10")) << "more than there is";
  EXPECT_THAT(told(rows({{99.9, 2}, {100, 1}, {100.1, 2}})), pulse("10")) << "a trough";
  EXPECT_THAT(told(rows({{4.1, 1}, {4.3, 2}, {4.7, 2}, {4.9, 1}, {1e7, 1}, {1.1e7, 1e3}})), pulse("0"))
      << "small beside what comes after the end";
  EXPECT_THAT(told(rows({{4.1, 1}, {4.3, 2}})), IsEmpty()) << "a jump";
  EXPECT_THAT(told(rows({{0, 1}, {5, 2}, {9, 1}})), IsEmpty());
  EXPECT_THAT(told(rows({{1e7, 1}, {1e7 + 0.5, 2}, {1e7 + 1, 1}})), IsEmpty()) << "after the end";
  EXPECT_THAT(told(rows({{0, 1}, {50.4, 2}, {100, 1}})), IsEmpty()) << "a slow peak";
  EXPECT_THAT(told(rows({{100, 1}, {120.4, 2}, {140, 1}})), IsEmpty()) << "one of 40 steps";
}

}  // namespace
}  // namespace vug
