// --resume with a later end of the run than it had.
#include "support/channel_runs.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

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

/// An end that --steps has moved is the run's from then on, and is told of once.
TEST(LaterEnd, OfStepsStays) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", moved = "the end of the run is moved from step 1000 to step ";
  ASSERT_EQ(run_channel(out, "").exit_code, 0);
  for (int time = 0; time < 2; ++time) {
    const Outcome again = run_channel(out, "--resume --steps 1400");
    EXPECT_EQ(again.exit_code, 0) << again.output;
    EXPECT_EQ(again.output.find(moved + "1400") != std::string::npos, time == 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("done at t = "));
  }
  const auto told = [&](const std::string& what) {
    const std::string events = line_of(out, "events");
    int count = 0;
    for (auto at = events.find(what); at != std::string::npos; at = events.find(what, at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(told(moved), 1) << line_of(out, "events");
  const Outcome plain = run_channel(out, "--resume");
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_EQ(plain.output.find("note: "), std::string::npos) << plain.output;
  EXPECT_THAT(plain.output, HasSubstr("step 1400: 0 steps"));
  EXPECT_THAT(run_channel(out, "--resume --steps 1200").output, HasSubstr("--steps 1200: the run is at step 1400 alr"));
  EXPECT_EQ(told("the end of the run is moved"), 1) << line_of(out, "events");
}

/// As an interrupted run, whose record has the end that it was given.
TEST(LaterEnd, OfStepsIsWhereAnInterruptedRunGoesOnTo) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", record = out + "/run.json";
  ASSERT_EQ(run_channel(folder / "whole", "--set time.steps=1400").exit_code, 0);
  ASSERT_EQ(run_channel(out, "").exit_code, 0);
  std::string text = test::contents(record);
  text.replace(text.find("\"last_step\": 1000"), 17, "\"last_step\": 1400");
  std::ofstream(record) << text;
  const Outcome plain = run_channel(out, "--resume");
  EXPECT_EQ(plain.exit_code, 0) << plain.output;
  EXPECT_EQ(plain.output.find("note: "), std::string::npos) << plain.output;
  EXPECT_THAT(line_of(out, "last_step"), HasSubstr("1400"));
  EXPECT_EQ(test::difference(folder / "whole", out), "");
}

/// A run ends at an age, wherever its steps end, and its last line has the age.
TEST(LaterEnd, OfStepsIsNoneWhereTheRockAges) {
  const TemporaryFolder folder;
  const std::string ages =
      "[lattice]\nsize = [20e-6, 10e-6]\nspacing = 1e-6\ntime_step = 1e-4\n[time]\nend = 20\n"
      "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [0, 0]\n"
      "to = [20e-6, 6e-6]\n[[solute.species]]\nname = \"H\"\ndiffusivity = 1e-9\ninitial = 1\n"
      "[reaction]\nreactant = \"H\"\nrate_constant = 1e-4\nmolar_volume = 4e-5\n"
      "[accuracy]\ndissolution_tolerance = 1e-2\n[boundary.top]\n"
      "solute = { type = \"concentration\", concentration = { H = 1 } }\n";
  std::ofstream(folder / "ages.toml") << ages;
  const std::string out = folder / "out", run = "run " + (folder / "ages.toml") + " --threads 1 -o " + out;
  const Outcome first = run_vug(run);
  ASSERT_EQ(first.exit_code, 0) << first.output;
  EXPECT_THAT(first.output, HasSubstr("done at t = 20"));
  const Outcome again = run_vug(run + " --resume --steps 3000000");
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_THAT(again.output,
              HasSubstr("note: --steps 3000000: a run with accuracy.dissolution_tolerance ends at the age "
                        "of 20 s (time.end) at the latest"));
  EXPECT_THAT(again.output, HasSubstr("done at t = 20"));
  EXPECT_EQ(line_of(out, "events").find("is moved"), std::string::npos) << line_of(out, "events");
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
