// The same case gives the same bits: on every run, for any number of threads, and after a restart.
#include "support/minerals_of_small_rock.hpp"
#include "support/rock_settings.hpp"
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace vug {
namespace {

using test::difference;
using test::run_vug;
using test::small_rock;
using test::TemporaryFolder;

void run(const std::string& folder, const std::string& more, const std::string& text = small_rock) {
  const test::Outcome outcome = run_vug("run " + text + " -o " + folder + " --quiet " + more);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.output;
}

/// Small triangles, so that there are groups of them, at rest until the cold fluid reaches them.
const char* const resting =
    "mechanics.rest_tolerance=1 --set rock.element_size=2e-3 --set mechanics.local_damping=0.8"
    " --set mechanics.bond.normal_strength=6e6";

class SameBitsOfRuns : public testing::TestWithParam<std::string> {};

TEST_P(SameBitsOfRuns, OnASecondRunAndWithTwoThreads) {
  const TemporaryFolder folder;
  const std::string choice = std::string(" --set ") + GetParam();
  run(folder / "one", "--threads 1" + choice);
  run(folder / "again", "--threads 1" + choice);
  run(folder / "two", "--threads 2" + choice);
  EXPECT_EQ(difference(folder / "one", folder / "again"), "");
  EXPECT_EQ(difference(folder / "one", folder / "two"), "");
}

/// Stops a run after each of these steps, resumes it on another number of threads and compares it with one that went
/// through.
void stop_and_resume(const std::string& choice, const std::vector<int>& stops) {
  const TemporaryFolder folder;
  // snapshots and checkpoints at every update of the pores, so that a part ends where the whole run has a snapshot too
  const std::string common =
      " --set output.checkpoint_interval=2.5e-5 --set output.interval=2.5e-5"
      " --set " +
      choice;
  run(folder / "whole", "--threads 1" + common);
  for (const int steps : stops) {
    const std::string parts = folder / ("parts" + std::to_string(steps));
    run(parts, "--threads 1 --steps " + std::to_string(steps) + common);
    run(parts, "--threads 2 --resume" + common);
    EXPECT_EQ(difference(folder / "whole", parts), "") << "restarted at step " << steps;
  }
}

TEST_P(SameBitsOfRuns, AfterARestartAcrossBirthsAndCracks) {
  stop_and_resume(GetParam(), {60, 200, 340});
}

INSTANTIATE_TEST_SUITE_P(Choices, SameBitsOfRuns,
                         testing::Values("accuracy.precision=double", "accuracy.precision=single",
                                         "accuracy.flow_tolerance=0.5 --set accuracy.guard_interval=10",
                                         // no divisors of the steps of a restart
                                         "accuracy.exchange_interval=7 --set accuracy.wall_interval=35", resting,
                                         "boundary.top.traction.support=servo",
                                         "damage.aperture=opening --set damage.residual_aperture=1e-4",
                                         "'" + test::several_materials + "' --set '" + test::moving_part + "' --set '" +
                                             test::gauges + "'"));

/// In place, populations are turned an odd number of steps after births, which were at step 55 and 135.
TEST(SameBitsOfTurned, AfterARestartBetweenTwoSteps) {
  const std::string odd =
      "accuracy.update_interval=5 --set output.interval=1.25e-5 --set output.checkpoint_interval=1.25e-5";
  stop_and_resume(odd, {60, 140});
  stop_and_resume(odd + " --set accuracy.solute_interval=3 --set accuracy.heat_interval=2", {60, 140});
}

TEST(SameBitsOfMinerals, WithThreadsAndAfterARestart) {
  const TemporaryFolder folder;
  for (const std::string precision : {"double", "single"}) {
    const std::string more =
        " --set output.checkpoint_interval=2.5e-5 --set output.interval=2.5e-5"
        " --set accuracy.precision=" +
        precision + test::minerals_on_command_line();
    const std::string whole = folder / ("whole_" + precision), parts = folder / ("parts_" + precision);
    run(whole, "--threads 1" + more);
    run(parts, "--threads 2 --steps 200" + more);
    run(parts, "--threads 1 --resume" + more);
    EXPECT_EQ(difference(whole, parts), "");
  }
}

TEST(SameBitsOfAWell, InDissolvingRockWithThreadsAndAfterARestart) {
  const TemporaryFolder folder;
  const std::string well = VUG_SOURCE_DIR "/tests/cases/coupled/well.toml";
  for (const std::string precision : {"double", "single"}) {
    const std::string more = " --set output.checkpoint_interval=0.02 --set accuracy.precision=" + precision;
    const std::string whole = folder / ("whole_" + precision), parts = folder / ("parts_" + precision);
    run(whole, "--threads 1" + more, well);
    run(parts, "--threads 2 --steps 200" + more, well);
    run(parts, "--threads 1 --resume" + more, well);
    EXPECT_EQ(difference(whole, parts), "");
  }
}

TEST(SameBitsOfAgeingRock, WithThreadsAndAfterARestart) {
  const TemporaryFolder folder;
  const std::string grain = VUG_SOURCE_DIR "/tests/cases/coupled/slow_grain.toml";
  for (const std::string precision : {"double", "single"}) {
    const std::string more = " --set accuracy.precision=" + precision;
    const std::string whole = folder / ("whole_" + precision), parts = folder / ("parts_" + precision);
    run(whole, "--threads 1 --steps 3000" + more, grain);
    run(parts, "--threads 1 --steps 2900" + more, grain);
    run(parts, "--threads 2 --resume --steps 3000" + more, grain);
    EXPECT_EQ(difference(whole, parts), "");
  }
}

TEST(SameBitsLong, AfterRestartsAtTwentySteps) {
  std::vector<int> updates(39), stops(20);
  std::iota(updates.begin(), updates.end(), 1);
  std::sample(updates.begin(), updates.end(), stops.begin(), 20, std::mt19937(1));
  for (int& stop : stops) stop *= 10;
  stop_and_resume("accuracy.precision=double", stops);
}

/// What Python prints of an expression over the history `r` of a run, a list of rows by column.
std::string of_history(const std::string& folder, const std::string& expression) {
  return test::run_command(VUG_PYTHON
                           " -c \"import csv; r = [{k: float(v) for k, v in x.items()} for x in "
                           "csv.DictReader(open('" +
                           folder + "/history.csv'))]; print(" + expression + ")\"")
      .output;
}

TEST(SameBitsOfRockThatIsGone, WithThreadsAndAfterARestart) {
  const TemporaryFolder folder;
  const std::string fast =
      " --set output.checkpoint_interval=2.5e-5 --set output.interval=2.5e-5 --set time.steps=200"
      " --set reaction.rate_constant=30 --set rock.element_size=2e-3 --set solute.species.0.diffusivity=5e-3";
  run(folder / "whole", "--threads 1" + fast);
  EXPECT_EQ(of_history(folder / "whole", "[x['triangles_dissolved_1'] > 0 for x in r if x['step_1'] in (150, 200)]"),
            "[True, True]\n");
  run(folder / "parts", "--threads 2 --steps 150" + fast);
  run(folder / "parts", "--threads 1 --resume" + fast);
  EXPECT_EQ(difference(folder / "whole", folder / "parts"), "");
}

TEST(SmallRock, ExercisesWhatItIsThereFor) {
  const TemporaryFolder folder;
  run(folder / "run", "--threads 1");
  EXPECT_EQ(of_history(folder / "run",
                       "r[-1]['nodes_dissolved_1'] > 0, r[-1]['nodes_opened_by_damage_1'] > 0, "
                       "r[-1]['bonds_failed_in_tension_1'] + r[-1]['bonds_failed_in_shear_1'] > 0"),
            "True True True\n");
}

/// All asleep, some and none; asleep at the first of the steps at which the run above is stopped.
TEST(SmallRock, SleepsAndWakes) {
  const TemporaryFolder folder;
  run(folder / "run", std::string("--threads 1 --set output.interval=2.5e-5 --set ") + resting);
  EXPECT_EQ(of_history(folder / "run",
                       "any(x['rock_awake_1'] == 0 for x in r), any(x['rock_awake_1'] == 1 for x in r), "
                       "any(0 < x['rock_awake_1'] < 1 for x in r), "
                       "[x['rock_awake_1'] for x in r if x['step_1'] == 60]"),
            "True True True [0.0]\n");
}

TEST(Balances, CloseToRoundOffInACoupledRun) {
  const TemporaryFolder folder;
  run(folder / "run", "--threads 1");
  const test::Outcome worst =
      test::run_command(VUG_PYTHON " -c \"import csv; rows = list(csv.DictReader(open('" + (folder / "run") +
                        "/history.csv'))); "
                        "errors = [k for k in rows[0] if k.endswith('balance_error_1')]; "
                        "print(len(errors), max(abs(float(r[k])) for r in rows for k in errors) < 1e-12)\"");
  EXPECT_EQ(worst.output, "6 True\n");
}

}  // namespace
}  // namespace vug
