// Whose a folder is: results are lost to nobody's mistake, and a run knows its own files.
#include "support/background_vug.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

namespace vug {
namespace {

using test::Outcome;
using test::run_command;
using test::run_vug;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

const std::string channel = VUG_SOURCE_DIR "/cases/poiseuille.toml";
const std::string small_lab =
    "lab " VUG_SOURCE_DIR
    "/cases/laboratory/compression.toml --quiet --set laboratory.size=[0.015,0.03]"
    " --set laboratory.platen_speed=2 --set rock.element_size=3e-3 --set laboratory.largest_strain=1e-3 -o ";

/// A quick run; what follows in `more` are words of the command line.
Outcome run(const std::string& folder, const std::string& more) {
  return run_vug("run " + channel + " --threads 1 --set output.interval_steps=100 --set time.steps=1000 -o " + folder +
                 " " + more);
}

std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "run.lock")
      files[entry.path().string()] = test::contents(entry.path().string());
  return files;
}

void expect_refused(const Outcome& outcome, const std::string& reason) {
  EXPECT_EQ(outcome.exit_code, 2) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr(reason));
}

int rows_of(const std::string& folder) {
  const std::string text = test::contents(folder + "/history.csv");
  return static_cast<int>(std::count(text.begin(), text.end(), '\n')) - 1;
}

TEST(RunFolder, WithARunIsRefusedAndLeftAsItIs) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  ASSERT_EQ(run(out, "--steps 300").exit_code, 0);
  const auto before = files_of(out);
  expect_refused(run(out, ""), "out: holds a run (done at step 300); --resume continues it, --overwrite replaces it");
  expect_refused(run(out, "--resume --overwrite"), "--overwrite");
  expect_refused(run_vug(small_lab + out), "holds a run");
  EXPECT_EQ(files_of(out), before);
}

TEST(RunFolder, IsOverwrittenOnDemandButForFilesOfOthers) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  ASSERT_EQ(run(out, "").exit_code, 0);
  const std::vector<std::string> others{
      "notes.txt",           "fields/mine.h5",     "fields/step_1.h5", "fields/step_a.h5.tmp",
      "checkpoint/mine.txt", "particles/rocks.h5", "figures/one.png"};
  for (const std::string& name : others) {
    fs::create_directories(fs::path(out + "/" + name).parent_path());
    test::write_text(out + "/" + name, "mine");
  }
  ASSERT_EQ(run(out, "--overwrite --steps 200").exit_code, 0);
  for (const std::string& name : others) EXPECT_EQ(test::contents(out + "/" + name), "mine") << name;
  EXPECT_EQ(rows_of(out), 3);
  EXPECT_FALSE(fs::exists(out + "/fields/step_000000000300.h5"));
  EXPECT_FALSE(fs::exists(out + "/checkpoint/step_000000001000.checkpoint"));
  EXPECT_EQ(run(out, "--resume").exit_code, 0);
  for (const std::string& name : others) EXPECT_EQ(test::contents(out + "/" + name), "mine") << name;
  EXPECT_EQ(rows_of(out), 11);
}

TEST(RunFolder, WithFilesOfAnotherProgramIsRefused) {
  const TemporaryFolder folder;
  for (const std::string name : {"history.csv", "fields.h5", "fields/step_000000000100.h5"}) {
    const std::string out = folder / "out";
    fs::create_directories(fs::path(out + "/" + name).parent_path());
    test::write_text(out + "/" + name, "mine");
    for (const char* use : {"", "--overwrite"}) expect_refused(run(out, use), name + ": is in the way");
    EXPECT_EQ(test::contents(out + "/" + name), "mine");
    fs::remove_all(out);
  }
  test::write_text(folder / "run.json", "{\n  \"status\": \"fine\"\n}\n");
  for (const char* use : {"", "--overwrite", "--resume"})
    expect_refused(run(folder.path(), use), "run.json: is no record");
  EXPECT_EQ(test::contents(folder / "run.json"), "{\n  \"status\": \"fine\"\n}\n");
}

TEST(RunFolder, ServesOneProcessAtATimeAndNamesIt) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  test::BackgroundVug first("run " + channel + " --quiet --threads 1 --set time.steps=1000000000 -o " + out,
                            folder / "log");
  ASSERT_TRUE(first.wait_for_file(out + "/fields.xdmf")) << first.log();
  const std::string name = "out: is in use by process " + std::to_string(first.pid()) + " on ";
  for (const char* use : {"", "--overwrite", "--resume"}) expect_refused(run(out, use), name);
  expect_refused(run_vug(small_lab + out), name);
  first.signal(SIGKILL);
  EXPECT_EQ(first.wait(), 128 + SIGKILL);
  expect_refused(run(out, ""), "holds a run (running");
  EXPECT_EQ(run(out, "--overwrite").exit_code, 0) << "the lock ended with its holder";
}

/// Of many that start at once one has the folder, and its files are those of a run alone.
TEST(RunFolder, IsGivenToOneOfManyThatStartAtOnce) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", command = "run " + channel +
                                                    " --quiet --threads 1 --set output.interval_steps=100"
                                                    " --set time.steps=1000 -o " +
                                                    out;
  std::vector<std::unique_ptr<test::BackgroundVug>> all;
  for (int i = 0; i < 6; ++i)
    all.push_back(std::make_unique<test::BackgroundVug>(command, folder / ("log" + std::to_string(i))));
  int done = 0, refused = 0;
  for (const auto& one : all) {
    const int code = one->wait();
    done += code == 0;
    refused += code == 2;
  }
  EXPECT_EQ(done, 1);
  EXPECT_EQ(refused, 5);
  ASSERT_EQ(run(folder / "alone", "--quiet").exit_code, 0);
  EXPECT_EQ(test::difference(folder / "alone", out), "");
}

TEST(RunFolder, OfALaboratoryTestIsProtectedAsWell) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  ASSERT_EQ(run_vug(small_lab + out).exit_code, 0);
  test::write_text(out + "/particles/mine.txt", "mine");
  const auto before = files_of(out);
  expect_refused(run_vug(small_lab + out), "out: holds a run (done at step 0); --overwrite replaces it");
  EXPECT_EQ(files_of(out), before);
  EXPECT_EQ(run_vug(small_lab + out + " --overwrite").exit_code, 0);
  EXPECT_EQ(test::contents(out + "/particles/mine.txt"), "mine");
}

/// A run that is begun anew where a longer one was goes on from its own state, not from the other one's end.
TEST(Resumed, RunTakesNoStateOfAnother) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", old = folder / "old";
  ASSERT_EQ(run(old, "").exit_code, 0);
  ASSERT_EQ(run(out, "--steps 150").exit_code, 0);
  for (const auto& entry : fs::directory_iterator(old + "/checkpoint"))
    fs::copy(entry.path(), out + "/checkpoint/" + entry.path().filename().string());
  const Outcome resumed = run(out, "--resume");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.output;
  EXPECT_THAT(resumed.output, HasSubstr("step_000000001000.checkpoint: the checkpoint belongs to another run"));
  EXPECT_THAT(test::contents(out + "/run.json"), HasSubstr("\"first_step\": 150,"));
  EXPECT_EQ(rows_of(out), 12) << "rows at 0, 100, 150, 200, ..., 1000";
}

TEST(Resumed, InAnEmptyFolderBeginsAndSaysSo) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "there");
  ASSERT_EQ(run(folder / "whole", "").exit_code, 0);
  for (const std::string name : {"there", "missing"}) {
    const Outcome outcome = run(folder / name, "--resume");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("has no checkpoint to continue from: the run begins at its first step"));
    EXPECT_EQ(test::difference(folder / "whole", folder / name), "");
  }
  fs::remove_all(folder / "there/checkpoint");  // as of a run that was killed before its first one
  EXPECT_EQ(run(folder / "there", "--resume").exit_code, 0);
  EXPECT_EQ(test::difference(folder / "whole", folder / "there"), "");
}

TEST(Resumed, AnotherCaseIsRefused) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  ASSERT_EQ(run(out, "--steps 300").exit_code, 0);
  const auto before = files_of(out);
  expect_refused(run(out, "--resume --set flow.density=999"), "another case, which this one cannot continue: the text");
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
  ASSERT_EQ(run(out, "").exit_code, 0);
  ASSERT_EQ(run(folder / "whole", "").exit_code, 0);
  std::string bytes = test::contents(newest);
  bytes[bytes.size() / 2] ^= 1;
  test::write_text(newest, bytes);
  const Outcome outcome = run(out, "--resume");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("warning: passed over: " + newest + ": the checkpoint is damaged"));
  EXPECT_EQ(test::difference(folder / "whole", out), "");
}

/// A history that was cut off goes on, and the log says what is missing.
TEST(Resumed, SaysThatTheHistoryHasLostRows) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", history = out + "/history.csv";
  ASSERT_EQ(run(out, "").exit_code, 0);
  const std::string whole = test::contents(history);
  const auto rows = std::count(whole.begin(), whole.end(), '\n') - 1;
  EXPECT_THAT(run(out, "--resume").output, Not(HasSubstr("lost")));
  test::write_text(history, whole.substr(0, whole.size() - 1));  // a row without its end
  EXPECT_THAT(run(out, "--resume").output,
              HasSubstr("warning: " + history + " has lost rows: " + std::to_string(rows - 1) + " of " +
                        std::to_string(rows) + " up to step 1000 are left"));
}

TEST(Checkpoints, AreThereAtTheEndWhateverTheIntervals) {
  const TemporaryFolder folder;
  const std::string odd = " --set accuracy.update_interval=1000000 --set output.interval_steps=1000";
  ASSERT_EQ(run(folder / "out", "--steps 7" + odd).exit_code, 0);
  EXPECT_TRUE(fs::exists(folder / "out/checkpoint/step_000000000007.checkpoint"));
}

TEST(Checkpoints, FromWhichARunWasResumedAreNamedWhenItDiverges) {
  const TemporaryFolder folder;
  // a viscosity far below what the pressure allows, and no limiter to save it
  const std::string out = folder / "out",
                    wild = "run " + test::small_rock +
                           " --quiet --set flow.viscosity=2e-6 --set flow.speed_limit=0 --set flow.pressure_scale=1"
                           " --set accuracy.guard_interval=10 -o " +
                           out;
  ASSERT_EQ(run_vug(wild + " --steps 1").exit_code, 0);
  const Outcome diverged = run_vug(wild + " --resume");
  EXPECT_EQ(diverged.exit_code, 3) << diverged.output;
  EXPECT_THAT(diverged.output, HasSubstr("the last good state is the checkpoint of step 1 in " + out));
}

}  // namespace
}  // namespace vug
