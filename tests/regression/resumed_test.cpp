// What --resume takes up, what it says is missing, and what it leaves alone.
#include "support/background_vug.hpp"
#include "support/channel_runs.hpp"

#include <gmock/gmock.h>

namespace vug {
namespace {

using test::expect_refused;
using test::files_of;
using test::line_of;
using test::Outcome;
using test::rows_of;
using test::run_channel;
using test::run_vug;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// A run that is begun anew where a longer one was goes on from its own state, not from the other one's end.
TEST(Resumed, RunTakesNoStateOfAnother) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", old = folder / "old";
  ASSERT_EQ(run_channel(old, "").exit_code, 0);
  ASSERT_EQ(run_channel(out, "--steps 150").exit_code, 0);
  for (const auto& entry : fs::directory_iterator(old + "/checkpoint"))
    fs::copy(entry.path(), out + "/checkpoint/" + entry.path().filename().string());
  const Outcome resumed = run_channel(out, "--resume");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_THAT(resumed.output, HasSubstr("step_000000001000.checkpoint: the checkpoint belongs to another run"));
  EXPECT_THAT(test::contents(out + "/run.json"), HasSubstr("\"first_step\": 150,"));
  EXPECT_EQ(rows_of(out), 12) << "rows at 0, 100, 150, 200, ..., 1000";
}

TEST(Resumed, InAnEmptyFolderBeginsAndSaysSo) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "there");
  ASSERT_EQ(run_channel(folder / "whole", "").exit_code, 0);
  for (const std::string name : {"there", "missing"}) {
    const Outcome outcome = run_channel(folder / name, "--resume");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("has no checkpoint to continue from: the run begins at its first step"));
    EXPECT_EQ(test::difference(folder / "whole", folder / name), "");
  }
}

/// A run that was killed before its first checkpoint has none: the same call takes it up, from the first step.
TEST(Resumed, AfterAKillBeforeTheFirstCheckpointBeginsAnew) {
  const TemporaryFolder folder;
  const std::string out = folder / "out",
                    endless = " --set time.steps=1000000000 --set output.interval_steps=1000000000";
  test::BackgroundVug killed("run " + test::channel + " --quiet --threads 1 -o " + out + endless, folder / "log");
  ASSERT_TRUE(killed.wait_for_file(out + "/fields.xdmf")) << killed.log();
  killed.signal(SIGKILL);
  killed.wait();
  const Outcome again = run_vug("run " + test::channel + " --threads 1 --steps 0 --resume -o " + out + endless);
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_THAT(again.output, HasSubstr("has no checkpoint to continue from: the run begins at its first step"));
}

/// Where a run has had a checkpoint that is gone, or nobody knows whose results these are, nothing is begun anew.
TEST(Resumed, WithoutTheCheckpointThatThereWasIsRefused) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", running = folder / "running";
  ASSERT_EQ(run_channel(out, "").exit_code, 0);
  fs::remove_all(out + "/checkpoint");
  const auto before = files_of(out);
  expect_refused(run_channel(out, "--resume"), "holds a run (done at step 1000) and no checkpoint to continue it from");
  EXPECT_EQ(files_of(out), before);
  fs::remove(out + "/run.json");
  expect_refused(run_channel(out, "--resume"), "is in the way, and no run.json says that vug wrote it");
  EXPECT_TRUE(fs::exists(out + "/history.csv"));

  test::BackgroundVug killed("run " + test::channel + " --quiet --threads 1 --set time.steps=1000000000 -o " + running +
                                 " --set output.interval_steps=100",
                             folder / "log");
  ASSERT_TRUE(killed.wait_for([&] {
    return test::contents(running + "/run.json").find("\"last_checkpoint\": 100,") != std::string::npos;
  })) << killed.log();
  killed.signal(SIGKILL);
  killed.wait();
  fs::remove_all(running + "/checkpoint");
  expect_refused(run_vug("run " + test::channel + " --resume --set time.steps=1000000000 -o " + running +
                         " --set output.interval_steps=100"),
                 "holds a run (unfinished at step");
}

/// What cannot be read is not absent.
TEST(Resumed, WithCheckpointsThatCannotBeReadIsAFailureOfTheFiles) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", checkpoints = out + "/checkpoint";
  ASSERT_EQ(run_channel(out, "--steps 300").exit_code, 0);
  fs::rename(checkpoints, folder / "elsewhere");
  const auto refused = [&](const std::string& why) {
    const auto before = files_of(out);
    const Outcome outcome = run_channel(out, "--quiet --resume");
    EXPECT_EQ(outcome.exit_code, 4) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("vug: " + checkpoints + ": cannot look for checkpoints: " + why));
    EXPECT_EQ(files_of(out), before);
  };
  fs::create_symlink(folder / "unmounted", checkpoints);
  refused("No such file");
  fs::remove(checkpoints);
  test::write_text(checkpoints, "mine");
  refused("Not a directory");
  fs::remove(checkpoints);
  fs::create_symlink(folder / "elsewhere", checkpoints);
  EXPECT_EQ(run_channel(out, "--resume").exit_code, 0) << "they are there again";
}

double wall_time_of(const std::string& folder) {
  return std::stod(line_of(folder, "wall_time_s").substr(std::string("\n  \"wall_time_s\": ").size()));
}

TEST(Resumed, KeepsTheEventsAndAddsUpTheTime) {
  const TemporaryFolder folder;
  const std::string whole = folder / "whole", parts = folder / "parts",
                    rock =
                        "run " + test::small_rock + " --quiet --threads 1 --set output.checkpoint_interval=2.5e-5 -o ";
  ASSERT_EQ(run_vug(rock + whole).exit_code, 0);
  ASSERT_THAT(line_of(whole, "events"), HasSubstr("bond has failed"));
  double before = 0;
  for (const char* steps : {" --steps 200", " --resume --steps 390", " --resume"}) {
    ASSERT_EQ(run_vug(rock + parts + steps).exit_code, 0);
    EXPECT_GT(wall_time_of(parts), before);
    before = wall_time_of(parts);
  }
  EXPECT_EQ(line_of(parts, "events"), line_of(whole, "events"));
  std::string newest;
  for (const auto& entry : fs::directory_iterator(parts + "/checkpoint"))
    newest = std::max(newest, entry.path().string());
  fs::remove(newest);
  ASSERT_EQ(run_vug(rock + parts + " --resume").exit_code, 0);
  EXPECT_EQ(line_of(parts, "events"), line_of(whole, "events")) << "what comes again is told once";
}

TEST(Resumed, ByAnotherProgramIsTold) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  ASSERT_EQ(run_channel(out, "--steps 200").exit_code, 0);
  EXPECT_THAT(test::contents(out + "/run.json"), HasSubstr("\"ranks\": 1,"));
  EXPECT_THAT(run_channel(out, "--steps 300 --resume").output, Not(HasSubstr("resumed with")));
  std::string record = test::contents(out + "/run.json");
  const std::string commit = "\"commit\": \"";
  ASSERT_NE(record.find(commit), std::string::npos);
  test::write_text(out + "/run.json", record.replace(record.find(commit) + commit.size(), 0, "old-"));
  for (const char* steps : {"--steps 400 --resume", "--steps 500 --resume"}) {
    const Outcome outcome = run_channel(out, steps);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_EQ(outcome.output.find("warning: step 300, resumed with vug ") != std::string::npos,
              std::string(steps).starts_with("--steps 400"))
        << outcome.output;
    EXPECT_THAT(line_of(out, "events"),
                testing::ContainsRegex("\"step 300, resumed with vug [^\"]*, before by vug [^ ]* "
                                       "\\(commit old-"));
  }
  EXPECT_EQ(rows_of(out), 6);
}

TEST(Resumed, WithFewerStepsThanThereAreAddsNothing) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  ASSERT_EQ(run_channel(out, "").exit_code, 0);
  const Outcome outcome = run_channel(out, "--resume --steps 100");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("note: --steps 100: the run is at step 1000 already"));
  EXPECT_THAT(run_vug("watch " + out).output, HasSubstr("done, step 1000 of 1000 (100 %)"));
  EXPECT_EQ(rows_of(out), 11);
}

TEST(Resumed, AnotherCaseIsRefused) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  ASSERT_EQ(run_channel(out, "--steps 300").exit_code, 0);
  const auto before = files_of(out);
  expect_refused(run_channel(out, "--resume --set flow.density=999"),
                 "another case, which this one cannot continue: the text");
  EXPECT_EQ(files_of(out), before);
}

TEST(Resumed, AChangedImageOrMeshIsRefusedByName) {
  const TemporaryFolder folder;
  const std::string complete = VUG_SOURCE_DIR "/tests/cases/complete/";
  for (const auto& [name, input] :
       {std::pair<std::string, std::string>{"image", "pores.raw"}, {"mesh", "square.msh"}}) {
    const std::string text = folder / (name + ".toml"), out = folder / name;
    fs::copy(complete + name + ".toml", text);
    fs::copy(complete + input, folder / input);
    ASSERT_EQ(run_vug("run " + text + " --quiet --steps 3 -o " + out).exit_code, 0) << name;
    EXPECT_THAT(test::contents(out + "/run.json"), HasSubstr(input + "\", \"bytes\": "));
    std::string changed = test::contents(folder / input);
    if (name == "image")
      std::reverse(changed.begin(), changed.end());
    else
      changed += "\n";
    test::write_text(folder / input, changed);
    const auto before = files_of(out);
    expect_refused(run_vug("run " + text + " --quiet --resume --steps 5 -o " + out), input + " has changed since");
    EXPECT_EQ(files_of(out), before);
  }
}

TEST(Resumed, PassesOverADamagedCheckpointAndSaysSo) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", newest = out + "/checkpoint/step_000000001000.checkpoint";
  ASSERT_EQ(run_channel(out, "").exit_code, 0);
  ASSERT_EQ(run_channel(folder / "whole", "").exit_code, 0);
  std::string bytes = test::contents(newest);
  bytes[bytes.size() / 2] ^= 1;
  test::write_text(newest, bytes);
  const Outcome outcome = run_channel(out, "--resume --quiet");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_TRUE(outcome.output.starts_with("warning: passed over: " + newest + ": the checkpoint is damaged"));
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << "a warning, and nothing else";
  EXPECT_EQ(test::difference(folder / "whole", out), "");
}

/// A history that was cut off goes on, and the log says what is missing, of slow scenes as well, of which nobody knows
/// beforehand in which steps their rows come.
TEST(Resumed, SaysThatTheHistoryHasLostRows) {
  const std::string slow = VUG_SOURCE_DIR "/tests/cases/coupled/slow_grain.toml";
  for (const std::string& command :
       {"run " + test::channel + " --threads 1 --set output.interval_steps=100 --set time.steps=1000 -o ",
        "run " + slow + " --threads 1 --set time.end=6 -o "}) {
    const TemporaryFolder folder;
    const std::string out = folder / "out", history = out + "/history.csv";
    ASSERT_EQ(run_vug(command + out).exit_code, 0);
    const std::string whole = test::contents(history);
    const auto rows = std::count(whole.begin(), whole.end(), '\n') - 1;
    ASSERT_GE(rows, 3);
    EXPECT_THAT(run_vug(command + out + " --resume").output, Not(HasSubstr("lost")));
    test::write_text(history, whole.substr(0, whole.size() - 1));  // a row without its end
    EXPECT_THAT(run_vug(command + out + " --resume").output,
                HasSubstr("warning: " + history + " has lost rows: " + std::to_string(rows - 1) + " of " +
                          std::to_string(rows) + " up to step"));
  }
}

/// A history without a whole header has no rows, and a snapshot that cannot be read is left out: neither is in the way
/// of a sound checkpoint.
TEST(Resumed, GoesOnBesideADamagedHistoryAndSnapshot) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", history = out + "/history.csv",
                    snapshot = out + "/fields/step_000000000400.h5";
  ASSERT_EQ(run_channel(out, "").exit_code, 0);
  const std::string whole = test::contents(history);
  for (const std::string& rest : {std::string(), whole.substr(0, 30)}) {
    test::write_text(history, rest);
    const Outcome outcome = run_channel(out, "--resume");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("has lost rows: 0 of "));
  }
  test::write_text(history, "other" + whole);
  EXPECT_EQ(run_channel(out, "--resume").exit_code, 4);
  test::write_text(history, whole);
  test::write_text(snapshot, test::contents(snapshot).substr(0, 1000));
  const Outcome outcome = run_channel(out, "--resume");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("warning: passed over: " + snapshot + ": "));
  EXPECT_THAT(test::contents(out + "/fields.xdmf"), Not(HasSubstr("step_000000000400")));
  EXPECT_THAT(test::contents(out + "/fields.xdmf"), HasSubstr("step_000000000500"));
}

}  // namespace
}  // namespace vug
