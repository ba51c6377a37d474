// What `vug check` says before a case costs anything.
#include "coupling/check.hpp"

#include "base/require.hpp"
#include "coupling/limit_text.hpp"
#include "coupling/simulation.hpp"
#include "support/obstacle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::obstacle;
using testing::HasSubstr;

TEST(Limits, NumberIsToldFromTheBoundItBreaks) {
  EXPECT_EQ(warning_of({"flow", "number", 0.2, "1", 0, 0.1, "lower it"}),
            "flow: number = 0.2 is outside 0 to 0.1; lower it");
  EXPECT_EQ(warning_of({"flow", "number", 0.1000003, "1", 0, 0.1, "lower it"}),
            "flow: number = 0.1000003 is outside 0 to 0.1; lower it");
  EXPECT_EQ(warning_of({"flow", "number", 0.49999999, "1", 0.5, std::numeric_limits<double>::infinity(), "raise it"}),
            "flow: number = 0.49999999 is outside >= 0.5; raise it");
}

TEST(Limits, AdviceToChangeSaysInWhichDirection) {
  const auto told = [](double value) {
    return warning_of({"heat", "tau", value, "1", 0.5, 3.5, "change lattice.time_step"});
  };
  EXPECT_EQ(told(0.4), "heat: tau = 0.4 is outside 0.5 to 3.5; raise lattice.time_step");
  EXPECT_EQ(told(4), "heat: tau = 4 is outside 0.5 to 3.5; lower lattice.time_step");
}

TEST(Check, SaysWhatItMeasured) {
  const CheckReport report = check_case(parse_scene(obstacle, "a.toml"));
  EXPECT_GE(report.measured_steps, 10);
  EXPECT_GE(report.threads, 1);
  EXPECT_GT(report.seconds_per_step, 0);
  EXPECT_DOUBLE_EQ(report.seconds, 1000 * report.seconds_per_step);
  const std::string text = to_text(report);
  EXPECT_THAT(text,
              HasSubstr("measured: the fastest 10 of the first " + std::to_string(report.measured_steps) + " steps"));
  EXPECT_THAT(text, HasSubstr("Mach number of the prescribed velocities"));
  EXPECT_THAT(text, HasSubstr("Mach number in the narrowest passage"));
  EXPECT_THAT(text, testing::Not(HasSubstr("that the pressures drive")));
}

/// Heat that is computed in every 32nd step only takes about a 32nd of the time, not none of it.
TEST(Check, MeasuresWhatIsDueAtIntervals) {
  const auto report = [](const std::string& set) {
    return check_case(parse_scene(test::heated_disc, "a.toml", {set}));
  };
  const CheckReport every = report("accuracy.heat_interval=1"), seldom = report("accuracy.heat_interval=32");
  EXPECT_EQ(seldom.measured_steps % 32, 0);
  EXPECT_EQ(seldom.batch, 32);
  EXPECT_GT(32 * seldom.seconds_per_step, every.seconds_per_step / 4);
  EXPECT_LT(seldom.seconds_per_step, every.seconds_per_step / 4);
  const CheckReport never = report("accuracy.heat_interval=900");
  EXPECT_GT(900 * never.seconds_per_step, every.seconds_per_step / 4);
  EXPECT_EQ(never.batch, 0);
  EXPECT_THAT(to_text(never), HasSubstr("measured: the first 900 steps, "));
  EXPECT_THAT(to_text(never), testing::Not(HasSubstr("too few")));
}

TEST(Check, CountsTheStepsThatHoldAllIntervals) {
  const auto counted = [](const std::vector<std::string>& intervals, const std::string& text = obstacle) {
    std::vector<std::string> set{"time.steps=1000000"};
    for (const std::string& interval : intervals) set.push_back("accuracy." + interval);
    const MeasuredSteps found = steps_to_measure(parse_scene(text, "a.toml", set));
    return std::pair{found.count, found.in_proportion};
  };
  const std::string reacts = obstacle + "[reaction]\nreactant = \"A\"\nrate_constant = 1e-3\nmolar_volume = 1e-3\n";
  EXPECT_EQ(counted({}), std::pair(10, true));
  EXPECT_EQ(counted({"heat_interval=4"}), std::pair(12, true));
  EXPECT_EQ(counted({"heat_interval=4", "solute_interval=6"}), std::pair(12, true));
  EXPECT_EQ(counted({"heat_interval=200"}), std::pair(200, true));
  EXPECT_EQ(counted({"heat_interval=7", "solute_interval=31"}), std::pair(31, false));
  EXPECT_EQ(counted({"update_interval=300"}), std::pair(10, true)) << "nothing to look at";
  EXPECT_EQ(counted({"update_interval=300"}, reacts), std::pair(300, false));
  EXPECT_EQ(counted({"update_interval=1000000"}, reacts), std::pair(1000, false));
  EXPECT_EQ(counted({"preset=\"fast\""}, reacts), std::pair(20, true));
  EXPECT_EQ(counted({"tolerance=1e-3", "heat_interval=64"}), std::pair(10, true)) << "begins with every step";
}

/// What is not in the time is said.
TEST(Check, SaysWhichIntervalItsMeasurementLacks) {
  const CheckReport report = check_case(
      parse_scene(obstacle + "[reaction]\nreactant = \"A\"\nrate_constant = 1e-3\nmolar_volume = 1e-3\n", "a.toml",
                  {"lattice.size=[40, 20]", "geometry.shapes.0.centre=[20, 10]", "geometry.shapes.0.radius=5",
                   "accuracy.update_interval=2000"}));
  EXPECT_EQ(report.measured_steps, 1000);
  EXPECT_THAT(to_text(report), HasSubstr("too few for accuracy.update_interval = 2000, whose time is not in it"));
}

/// Where the clock of the processor ticks coarsely, the fastest batch takes no time.
TEST(Check, TimeOfAStepIsThatOfTheFinestClockThatTicked) {
  EXPECT_EQ(time_of_a_step(1, 2, 3), 1);
  EXPECT_EQ(time_of_a_step(0, 2, 3), 2);
  EXPECT_EQ(time_of_a_step(0, 0, 3), 3);
}

/// A flow that may be held, and intervals that may grow, cost no more than the first steps do.
TEST(Check, SaysAtMostWhereStepsMayTurnOutCheaper) {
  for (const auto& [key, cheaper] : {std::pair{"accuracy.flow_tolerance=0", false},
                                     {"accuracy.flow_tolerance=1e-3", true},
                                     {"accuracy.tolerance=1e-3", true}}) {
    const CheckReport report = check_case(parse_scene(obstacle, "a.toml", {key}));
    EXPECT_EQ(to_text(report).find("at most 1000 steps") != std::string::npos, cheaper) << key;
    EXPECT_EQ(to_json(report).find("\"at_most\": true") != std::string::npos, cheaper) << key;
  }
}

/// Populations per lattice step: heat's of all nodes, those of flow and species of fluid; a longer interval has less.
TEST(RowWeights, CountPopulationsOverTheirIntervals) {
  const auto weights = [](const std::string& intervals) {
    const Scene scene = parse_scene(
        "[lattice]\nsize = [10, 4]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 8\n[flow]\nviscosity = 0.1\n"
        "[heat]\nfluid_diffusivity = 0.01\nsolid_diffusivity = 0.01\n[[solute.species]]\nname = \"A\"\n"
        "diffusivity = 0.01\n[[solute.species]]\nname = \"B\"\ndiffusivity = 0.01\n[geometry]\ntype = \"shapes\"\n"
        "[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [4, 0]\nto = [10, 2]\n[accuracy]\n" +
            intervals,
        "a.toml");
    const Simulation simulation(scene);
    return row_weights(scene, simulation.parts().geometry);
  };
  const auto expected = [](double heat, double solutes) {
    const double rock = 10 * heat + 4 * (9 + solutes), open = 10 * heat + 10 * (9 + solutes);
    return std::vector<double>{rock, rock, open, open};
  };
  EXPECT_EQ(weights(""), expected(5, 10));
  EXPECT_EQ(weights("heat_interval = 8\nsolute_interval = 4\n"), expected(5.0 / 8, 10.0 / 4));
}

TEST(Check, KnowsTheSpecimenOfALaboratoryTest) {
  const Scene scene =
      parse_scene("[laboratory]\ntest = \"compression\"\nsize = [0.02, 0.04]\n[rock]\nelement_size = 2e-3\n", "a.toml");
  const CheckReport report = check_case(scene);
  EXPECT_GT(report.particles, 300);
  EXPECT_GT(report.bonds, report.particles);
  EXPECT_GT(report.steps, 10000);  // 0.02 of 40 mm at 0.5 m/s in sub-steps of some 30 ns
  const std::string text = to_text(report);
  EXPECT_THAT(text, testing::StartsWith("specimen of "));
  EXPECT_THAT(text, HasSubstr("bytes per triangle"));
  EXPECT_THAT(text, HasSubstr("mean edge of the bonds"));
  EXPECT_THROW(check_case(parse_scene(scene.source_text, "a.toml", {"output.fields=[\"stres\"]"})), InputError);
}

/// "A", shape "stored" and "A_gain_shape", its "stored": no rule of names foresees this.
TEST(Check, RefusesTwoColumnsOfOneName) {
  const std::vector<std::string> overrides{
      "geometry.shapes.1={ type = \"disc\", centre = [150, 50], radius = 9, name = \"stored\" }",
      "boundary.shape.stored.solute={ type = \"concentration\", concentration = { A = 1 } }",
      "solute.species.1.name=A_gain_shape"};
  try {
    check_case(parse_scene(obstacle, "a.toml", overrides));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("a.toml: two columns of the history would be called "
                                                  "\"A_gain_shape_stored_mol_per_m\"; "));
  }
}

TEST(Check, KnowsTheFieldsThatARunWrites) {
  EXPECT_NO_THROW(check_case(parse_scene(obstacle, "a.toml", {"output.fields=[\"velocity\"]"})));
  EXPECT_THROW(check_case(parse_scene(obstacle, "a.toml", {"output.fields=[\"velocty\"]"})), InputError);
}

}  // namespace
}  // namespace vug
