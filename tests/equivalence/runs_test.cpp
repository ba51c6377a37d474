// The same case gives the same bits: on every run, for any number of threads, and after a restart.
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

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

class SameBits : public testing::TestWithParam<const char*> {};

TEST_P(SameBits, OnASecondRunAndWithTwoThreads) {
  const TemporaryFolder folder;
  const std::string precision = std::string(" --set accuracy.precision=") + GetParam();
  run(folder / "one", "--threads 1" + precision);
  run(folder / "again", "--threads 1" + precision);
  run(folder / "two", "--threads 2" + precision);
  EXPECT_EQ(difference(folder / "one", folder / "again"), "");
  EXPECT_EQ(difference(folder / "one", folder / "two"), "");
}

TEST_P(SameBits, AfterARestartAcrossBirthsAndCracks) {
  const TemporaryFolder folder;
  const std::string precision = std::string(" --set accuracy.precision=") + GetParam();
  // snapshots and checkpoints every 20 steps, so that a part ends where the whole run has a snapshot too
  const std::string checkpoints = " --set output.checkpoint_interval=5e-5 --set output.interval=5e-5";
  run(folder / "whole", "--threads 1" + checkpoints + precision);
  for (const int steps : {60, 200, 340}) {
    const std::string parts = folder / ("parts" + std::to_string(steps));
    run(parts, "--threads 1 --steps " + std::to_string(steps) + checkpoints + precision);
    run(parts, "--threads 2 --resume" + checkpoints + precision);
    EXPECT_EQ(difference(folder / "whole", parts), "") << "restarted at step " << steps;
  }
}

TEST_P(SameBits, OfAWellInDissolvingRockWithThreadsAndAfterARestart) {
  const TemporaryFolder folder;
  const std::string well = VUG_SOURCE_DIR "/tests/cases/coupled/well.toml";
  const std::string more = std::string(" --set output.checkpoint_interval=0.02 --set accuracy.precision=") + GetParam();
  run(folder / "whole", "--threads 1" + more, well);
  run(folder / "parts", "--threads 2 --steps 200" + more, well);
  run(folder / "parts", "--threads 1 --resume" + more, well);
  EXPECT_EQ(difference(folder / "whole", folder / "parts"), "");
}

INSTANTIATE_TEST_SUITE_P(Precisions, SameBits, testing::Values("double", "single"));

TEST(SmallRock, ExercisesWhatItIsThereFor) {
  const TemporaryFolder folder;
  run(folder / "run", "--threads 1");
  const test::Outcome last =
      test::run_command(VUG_PYTHON " -c \"import csv; r = list(csv.DictReader(open('" + (folder / "run") +
                        "/history.csv')))[-1]; "
                        "print(float(r['nodes_dissolved_1']) > 0 and float(r['nodes_opened_by_damage_1']) > 0 and "
                        "float(r['bonds_failed_in_tension_1']) + float(r['bonds_failed_in_shear_1']) > 0)\"");
  EXPECT_EQ(last.output, "True\n");
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
