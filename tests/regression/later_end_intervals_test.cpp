// A later end where the former one was in the middle of intervals: heat, solutes, forces and looks at the rock go on as
// if the run had never ended.
#include "support/channel_runs.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::Outcome;
using test::run_vug;
using test::TemporaryFolder;

/// The case in which everything happens, up to a step, with a row and a snapshot every 50 steps.
Outcome run_to(int steps, const std::string& where, const std::vector<std::string>& choices) {
  std::string command = "run " + test::small_rock + " --quiet --threads 1 --set output.interval=1.25e-4" +
                        " --set output.history_interval=1.25e-4 --set time.steps=" + std::to_string(steps) + " -o " +
                        where;
  for (const std::string& choice : choices) command += " --set " + choice;
  return run_vug(command);
}

class LaterEndInIntervals : public testing::TestWithParam<std::vector<std::string>> {};

TEST_P(LaterEndInIntervals, HasTheBitsOfARunThatHadItFromTheStart) {
  const TemporaryFolder folder;
  const std::string whole = folder / "whole", out = folder / "out";
  ASSERT_EQ(run_to(300, whole, GetParam()).exit_code, 0);
  ASSERT_EQ(run_to(150, out, GetParam()).exit_code, 0);
  const Outcome outcome = run_to(300, out + " --resume", GetParam());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(test::difference(whole, out), "");
}

/// The rows of a history but that of one step.
std::string rows_without(int step, const std::string& folder) {
  std::istringstream history(test::contents(folder + "/history.csv"));
  std::string kept, line, header;
  std::getline(history, header);
  const std::string mark = "," + std::to_string(step) + ",";  // after the time
  while (std::getline(history, line))
    if (line.find(mark) != line.find(',')) kept += line + "\n";
  return header + "\n" + kept;
}

/// The former end need not be at a row of the schedule either: its own row stays, and disturbs nothing.
TEST_P(LaterEndInIntervals, IsNotDisturbedByTheRowOfTheFormerEnd) {
  const TemporaryFolder folder;
  const std::string whole = folder / "whole", out = folder / "out";
  ASSERT_EQ(run_to(200, whole, GetParam()).exit_code, 0);
  ASSERT_EQ(run_to(137, out, GetParam()).exit_code, 0);
  const Outcome outcome = run_to(200, out + " --resume", GetParam());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(test::rows_of(out), test::rows_of(whole) + 1);
  EXPECT_EQ(rows_without(137, out), test::contents(whole + "/history.csv"));
}

using Set = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(Choices, LaterEndInIntervals,
                         testing::Values(Set{"accuracy.heat_interval=4", "accuracy.solute_interval=7",
                                             "accuracy.exchange_interval=11", "accuracy.update_interval=40",
                                             "accuracy.wall_interval=35"},
                                         Set{"accuracy.tolerance=0.1"},
                                         Set{"accuracy.tolerance=0.1", "flow.gravity=[0,-9.81]",
                                             "flow.thermal_expansion=1e-3", "accuracy.precision=single"},
                                         Set{"accuracy.flow_tolerance=0.5", "accuracy.guard_interval=40",
                                             "accuracy.dissolution_factor=100"}));

}  // namespace
}  // namespace vug
