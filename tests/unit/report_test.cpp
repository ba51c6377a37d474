// A bundle of a run, replayed somewhere else.
#include "front/report.hpp"

#include "support/run_vug.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace vug {
namespace {

namespace fs = std::filesystem;
using test::contents;
using testing::HasSubstr;

const std::string source = fs::absolute(VUG_SOURCE_DIR).lexically_normal().string();
const std::string program = fs::absolute(VUG_EXECUTABLE).lexically_normal().string();
const std::string rock = source + "/tests/cases/coupled/small_rock.toml";

class Report : public testing::Test {
 protected:
  test::Outcome vug(const std::string& arguments) const {
    return test::run_command("cd " + folder_.path() + " && OMP_PROC_BIND=false " + program + " " + arguments);
  }
  /// The bundle where nothing of the run is.
  test::Outcome replay_elsewhere(const std::string& bundle) const {
    fs::create_directories(folder_ / "elsewhere");
    fs::rename(folder_ / bundle, folder_ / "elsewhere/bundle");
    return test::run_command("OMP_PROC_BIND=false VUG=" + program + " " + (folder_ / "elsewhere/bundle/replay"));
  }
  std::string replayed(const std::string& file) const { return folder_ / ("elsewhere/bundle/replayed/" + file); }
  const test::TemporaryFolder folder_;
};

TEST_F(Report, GivesTheSameBytesElsewhereFromTheCheckpointBeforeTheEnd) {
  const std::string every_step = " --quiet --set output.interval=1e-5 --set output.checkpoint_interval=1e-4";
  ASSERT_EQ(vug("run " + rock + every_step + " --steps 150 -o run").exit_code, 0);
  const test::Outcome told = vug("report run/");
  ASSERT_EQ(told.exit_code, 0) << told.output;
  EXPECT_THAT(told.output, HasSubstr("run-report: "));
  EXPECT_THAT(told.output, HasSubstr("replays from the checkpoint of step 120"));
  EXPECT_THAT(contents(folder_ / "run-report/README.txt"), HasSubstr("done, step 150"));
  const test::Outcome outcome = replay_elsewhere("run-report");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("the same history, byte for byte"));
  EXPECT_EQ(contents(replayed("history.csv")), contents(folder_ / "run/history.csv"));
  EXPECT_THAT(contents(replayed("run.json")), HasSubstr("\"first_step\": 120"));
  for (const char* file : {"particles/rock.h5", "fields/step_000000000124.h5"})  // though the bundle has no snapshots
    EXPECT_EQ(contents(replayed(file)), contents(folder_ / ("run/" + std::string(file)))) << file;
}

/// Rows stay where a former end put them, which a replay from the first step would not write.
TEST_F(Report, OfARunWhoseEndWasMovedBeginsAtTheFormerEnd) {
  test::write_text(folder_ / "rock.toml", contents(rock));
  const auto ends_after = [&](int steps) { return fmt::format(" --quiet --set time.steps={} -o run", steps); };
  ASSERT_EQ(vug("run rock.toml" + ends_after(133)).exit_code, 0);
  ASSERT_EQ(vug("run rock.toml --resume" + ends_after(150)).exit_code, 0);
  EXPECT_THAT(vug("report run").output, HasSubstr("replays from the checkpoint of step 133"));
  const test::Outcome outcome = replay_elsewhere("run-report");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_EQ(contents(replayed("history.csv")), contents(folder_ / "run/history.csv"));
}

/// The last row may be in the midst of being written.
TEST_F(Report, OfARunUnderWayHasWholeRowsOnly) {
  ASSERT_EQ(vug("run " + rock + " --quiet --steps 20 -o run").exit_code, 0);
  const std::string rows = contents(folder_ / "run/history.csv");
  test::write_text(folder_ / "run/history.csv", rows + "2.1e-4,21,0.");
  const test::Outcome told = vug("report run -o 'the run'\\''s'");
  EXPECT_THAT(told.output, HasSubstr("to send it: tar -czf 'the run'\\''s.tar.gz' 'the run'\\''s'"));
  EXPECT_EQ(contents(folder_ / "the run's/run/history.csv"), rows);
  const test::Outcome outcome = replay_elsewhere("the run's");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
}

TEST_F(Report, TellsAnotherHistory) {
  ASSERT_EQ(vug("run " + rock + " --quiet --steps 20 -o run").exit_code, 0);
  ASSERT_EQ(vug("report run").exit_code, 0);
  std::string history = contents(folder_ / "run-report/run/history.csv");
  history[history.size() - 3] = history[history.size() - 3] == '1' ? '2' : '1';
  test::write_text(folder_ / "run-report/run/history.csv", history);
  const test::Outcome outcome = replay_elsewhere("run-report");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("another history"));
}

TEST_F(Report, OfARunThatDivergedDivergesAgain) {
  const std::string too_much = " --set boundary.injection.flow.pressure=3e9 --set output.checkpoint_interval=1e-5";
  ASSERT_EQ(vug("run " + rock + " --quiet -o run" + too_much).exit_code, 3);
  ASSERT_EQ(vug("report run").exit_code, 0);
  EXPECT_THAT(contents(folder_ / "run-report/README.txt"), HasSubstr("diverged"));
  const std::string script = contents(folder_ / "run-report/replay");
  const test::Outcome outcome = replay_elsewhere("run-report");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(contents(replayed("run.json")), HasSubstr("\"status\": \"diverged\""));
  fs::remove_all(folder_ / "elsewhere/bundle/replayed");
  const auto steps = script.find("--steps ") + 8;  // one that stops before is another run
  test::write_text(folder_ / "elsewhere/bundle/replay", script.substr(0, steps) + "4" + script.substr(steps + 1));
  EXPECT_EQ(test::run_command("VUG=" + program + " " + (folder_ / "elsewhere/bundle/replay")).exit_code, 1);
}

TEST_F(Report, HasTheFilesOfTheCaseWhereTheCaseLooksForThem) {
  fs::create_directories(folder_ / "work/cases");
  fs::create_directories(folder_ / "work/it's data");
  fs::copy_file(source + "/cases/ct_slice/slice.tif", folder_ / "work/it's data/slice.tif");
  fs::copy_file(source + "/cases/ct_slice/ct_slice.toml", folder_ / "work/cases/ct_slice.toml");
  const std::string file = " --set \"geometry.file=\\\"../it's data/slice.tif\\\"\"";
  ASSERT_EQ(vug("run work/cases/ct_slice.toml --quiet --steps 20 -o run" + file).exit_code, 0);
  EXPECT_EQ(vug("report run").exit_code, 0);
  fs::rename(folder_ / "work", folder_ / "gone");
  const test::Outcome without = vug("report run -o without");
  EXPECT_THAT(without.output, HasSubstr("slice.tif: not in the bundle: cannot be read from here"));
  const test::Outcome outcome = replay_elsewhere("run-report");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
}

TEST_F(Report, DoesNotTakeAFileThatHasChanged) {
  fs::copy(source + "/cases/ct_slice", folder_ / "case");
  ASSERT_EQ(vug("run case/ct_slice.toml --quiet --steps 2 -o run").exit_code, 0);
  fs::copy_file(source + "/docs/quickstart.png", folder_ / "case/slice.tif", fs::copy_options::overwrite_existing);
  EXPECT_THAT(vug("report run").output, HasSubstr("case/slice.tif: not in the bundle: has changed since the run"));
  EXPECT_FALSE(fs::exists(folder_ / "run-report/case/slice.tif"));
}

TEST_F(Report, DoesNotTakeAFolderThatCannotBeReadForOneWithoutCheckpoints) {
  ASSERT_EQ(vug("run " + rock + " --steps 120 -o run").exit_code, 0);
  fs::remove_all(folder_ / "run/checkpoint");
  std::ofstream(folder_ / "run/checkpoint") << "no folder";
  const test::Outcome report = vug("report run");
  EXPECT_EQ(report.exit_code, 4) << report.output;
  EXPECT_THAT(report.output, HasSubstr("run/checkpoint: cannot look for checkpoints: Not a directory"));
  EXPECT_FALSE(fs::exists(folder_ / "run-report"));
}

TEST_F(Report, RefusesAndLeavesNothing) {
  EXPECT_EQ(vug("report no_run").exit_code, 2);
  ASSERT_EQ(vug("run " + rock + " --quiet --steps 2 -o run").exit_code, 0);
  fs::create_directory(folder_ / "run-report");
  const test::Outcome outcome = vug("report run");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.output, HasSubstr("run-report: is there already"));
  EXPECT_TRUE(fs::is_empty(folder_ / "run-report"));
  fs::remove(folder_ / "run/history.csv");
  EXPECT_EQ(vug("report run -o other").exit_code, 2);
  for (const char* name : {"no_run-report", "other", "other.tmp", "run-report.tmp"})
    EXPECT_FALSE(fs::exists(folder_ / name)) << name;
}

}  // namespace
}  // namespace vug
