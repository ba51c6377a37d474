// A run under way in a terminal.
#include "front/watch.hpp"

#include "base/require.hpp"
#include "support/no_locks.hpp"
#include "support/run_vug.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace vug {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(Sparkline, HasTheHeightOfTheLastValueUntilEachMoment) {
  EXPECT_EQ(sparkline({0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, 7), "▂▃▄▅▆▇█");
  EXPECT_EQ(sparkline({0, 3, 4}, {5, 5, 1}, 4), "███▁");  // rows need not be evenly spaced
  EXPECT_EQ(sparkline({0, 1}, {2, 2}, 3), "▁▁▁");
  EXPECT_EQ(sparkline({0, 1}, {2, NAN}, 2), "▁!");
}

WatchedRun half_done() {
  RunSummary summary;
  summary.status = "running";
  summary.first_step = "0";
  summary.last_step = "400";
  const History history{
      {"time_s", "step_1", "mass_initial_kg", "area_m2", "still_1", "a_balance_error_1", "b_balance_error_1"},
      {{0, 1e-3}, {0, 100}, {1, 2}, {3, 4}, {7, 7}, {0, 1e-12}, {0, -3e-10}}};
  return {summary, history, InUse::yes, 60, "", 7};
}

TEST(Watch, SaysHowFarARunIsAndWhatChanges) {
  const std::string text = watch_text(half_done(), {});
  EXPECT_THAT(text, HasSubstr("running, step 100 of 400 (25 %), 0.001 s of physical time, 3 min 00 s left"));
  EXPECT_THAT(text, HasSubstr("area_m2"));
  EXPECT_THAT(text, HasSubstr("largest error of a balance: 3.0e-10 (b)"));
  for (const char* left_out : {"mass_initial", "still_1", "step_1"}) EXPECT_THAT(text, Not(HasSubstr(left_out)));
  EXPECT_THAT(watch_text(half_done(), {80, 24, {"still_1"}}), HasSubstr("still_1"));
  EXPECT_THROW(watch_text(half_done(), {80, 24, {"are_m2"}}), InputError);
}

TEST(Watch, TellsARunThatWasKilled) {
  WatchedRun run = half_done();
  run.in_use = InUse::no;
  EXPECT_THAT(watch_text(run, {}), HasSubstr("ended without a word (killed?), step 100 of 400"));
}

TEST(Watch, SaysSoWhereNobodyCanTellWhetherARunGoesOn) {
  WatchedRun run = half_done();
  run.in_use = InUse::unknown;
  run.doubt = "this file system has no locks (Function not implemented)";
  EXPECT_THAT(
      watch_text(run, {}),
      testing::StartsWith("running, or ended without a word: this file system has no locks (Function not "
                          "implemented); last row 7 s ago, step 100 of 400 (25 %), 0.001 s of physical time\n"));
}

/// What the lock of a folder tells, and what `watch` makes of a run of 50 steps whose run.json says `status`.
struct Locked {
  explicit Locked(const std::string& host) {
    test::run_vug("run " VUG_SOURCE_DIR "/cases/tutorial/channel.toml --quiet --steps 50 -o " + directory);
    test::write_text(directory + "/run.lock", "process 1 on " + host + " since 2026-01-31T23:59:59Z\n");
    record = test::contents(directory + "/run.json");
    const std::string done = "\"status\": \"done\"";
    std::string running = record;
    if (const auto at = running.find(done); at != std::string::npos)
      running.replace(at, done.size(), "\"status\": \"running\"");
    test::write_text(directory + "/run.json", running);
  }
  test::TemporaryFolder folder;
  std::string directory = folder / "run", record, seen;
  int looks = 0;
  /// Watches until the run is done, as it is when somebody has looked twice.
  bool watched(bool once) {
    return watch(directory, {}, once, [this](const std::string& text) {
      if (seen.empty()) seen = text;
      if (++looks == 2) test::write_text(directory + "/run.json", record);
    });
  }
};

std::string this_host() {
  char name[256] = "";
  return gethostname(name, sizeof(name) - 1) == 0 ? name : "an unnamed host";
}

TEST(Watch, GoesOnWhereTheFileSystemHasNoLocks) {
  Locked run(this_host());
  EXPECT_EQ(is_in_use(run.directory), InUse::no);
  EXPECT_FALSE(run.watched(true));
  EXPECT_THAT(run.seen, HasSubstr("ended without a word (killed?), step 50 of"));
  run.seen.clear();
  const test::NoLocks none;
  std::string why;
  EXPECT_EQ(is_in_use(run.directory, &why), InUse::unknown);
  EXPECT_EQ(why, "this file system has no locks (Function not implemented)");
  EXPECT_TRUE(run.watched(false));
  EXPECT_THAT(run.seen, HasSubstr("running, or ended without a word: this file system has no locks"));
  EXPECT_EQ(run.looks, 3) << "looked until the run was done";
}

TEST(Watch, DoesNotTakeTheLockOfAnotherMachineForFree) {
  Locked run("node17.cluster");
  std::string why;
  EXPECT_EQ(is_in_use(run.directory, &why), InUse::unknown);
  EXPECT_EQ(why, "its lock is of another machine, node17.cluster, and may not be seen from here");
  EXPECT_TRUE(run.watched(true));
  EXPECT_THAT(run.seen, HasSubstr("running, or ended without a word: its lock is of another machine"));
}

TEST(Watch, OfAFinishedRunEndsAtOnce) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(
      test::run_vug("run " VUG_SOURCE_DIR "/cases/tutorial/channel.toml --quiet --steps 50 -o " + (folder / "run"))
          .exit_code,
      0);
  const test::Outcome seen = test::run_vug("watch " + (folder / "run"));
  EXPECT_EQ(seen.exit_code, 0) << seen.output;
  EXPECT_THAT(seen.output, HasSubstr("done, step 50 of 50 (100 %)"));
  EXPECT_EQ(test::run_vug("watch " + folder.path()).exit_code, 2);
  EXPECT_EQ(test::run_vug("watch " + (folder / "run") + " --columns no_such").exit_code, 2);
}

}  // namespace
}  // namespace vug
