// --resume with a later end of the run than it had.
#include "support/channel_runs.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace vug {
namespace {

using test::expect_refused;
using test::files_of;
using test::line_of;
using test::Outcome;
using test::run_channel;
using test::run_vug;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(LaterEnd, HasTheBitsOfARunThatHadItFromTheStart) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", later = "--set time.steps=1500 ";
  ASSERT_EQ(run_channel(folder / "whole", later).exit_code, 0);
  ASSERT_EQ(run_channel(folder / "longer", "--set time.steps=1800").exit_code, 0);
  ASSERT_EQ(run_channel(out, "").exit_code, 0);
  // a run that is stopped before its first checkpoint with the new end continues from one with the former end
  for (const std::string steps : {"--steps 1000", ""}) {
    const Outcome outcome = run_channel(out, "--resume " + later + steps);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.output.find("note: the end of the run is moved from step 1000 to step 1500") != std::string::npos,
              !steps.empty())
        << outcome.output;
  }
  EXPECT_THAT(line_of(out, "events"), HasSubstr("step 1000, the end of the run is moved from step 1000 to step 1500"));
  EXPECT_EQ(test::difference(folder / "whole", out), "");
  const auto before = files_of(out);
  EXPECT_EQ(
      std::count_if(before.begin(), before.end(), [](const auto& file) { return file.first.ends_with(".checkpoint"); }),
      2);
  expect_refused(run_channel(out, "--resume"), "another case, which this one cannot continue: its end is later");
  expect_refused(run_channel(out, "--resume --set time.steps=1600 --set flow.density=999"), "the text of the case");
  EXPECT_EQ(files_of(out), before);
  const Outcome beyond = run_channel(out, "--resume --steps 1800 " + later);
  EXPECT_EQ(beyond.exit_code, 0) << beyond.output;
  EXPECT_THAT(beyond.output, HasSubstr("note: the end of the run is moved from step 1500 to step 1800"));
  EXPECT_EQ(test::difference(folder / "longer", out), "");
}

TEST(LaterEnd, OfASlowSceneHasItsHistory) {
  const TemporaryFolder folder;
  const auto run_to = [&](const std::string& end, const std::string& where) {
    return run_vug("run " VUG_SOURCE_DIR "/tests/cases/coupled/slow_grain.toml --threads 1 --set time.end=" + end +
                   " -o " + (folder / where));
  };
  ASSERT_EQ(run_to("9", "whole").exit_code, 0);
  ASSERT_EQ(run_to("6", "out").exit_code, 0);
  const Outcome outcome = run_to("9", "out --resume");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("note: the end of the run is moved from 6 s to 9 s"));
  EXPECT_EQ(test::contents(folder / "whole/history.csv"), test::contents(folder / "out/history.csv"));
}

}  // namespace
}  // namespace vug
