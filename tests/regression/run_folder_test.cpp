// Whose a folder is: results are lost to nobody's mistake, and a run knows its own files.
#include "support/background_vug.hpp"
#include "support/channel_runs.hpp"

#include <gmock/gmock.h>

namespace vug {
namespace {

using test::channel;
using test::expect_refused;
using test::files_of;
using test::Outcome;
using test::rows_of;
using test::run_channel;
using test::run_vug;
using test::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string small_lab =
    "lab " VUG_SOURCE_DIR
    "/cases/laboratory/compression.toml --quiet --set laboratory.size=[0.015,0.03]"
    " --set laboratory.platen_speed=2 --set rock.element_size=3e-3 --set laboratory.largest_strain=1e-3 -o ";

TEST(RunFolder, WithARunIsRefusedAndLeftAsItIs) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  ASSERT_EQ(run_channel(out, "--steps 300").exit_code, 0);
  const auto before = files_of(out);
  expect_refused(run_channel(out, ""),
                 "out: holds a run (done at step 300); --resume continues it, --overwrite replaces it");
  expect_refused(run_channel(out, "--resume --overwrite"), "--overwrite");
  expect_refused(run_vug(small_lab + out), "holds a run");
  EXPECT_EQ(files_of(out), before);
}

TEST(RunFolder, IsOverwrittenOnDemandButForFilesOfOthers) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  ASSERT_EQ(run_channel(out, "").exit_code, 0);
  const std::vector<std::string> others{
      "notes.txt",           "fields/mine.h5",     "fields/step_1.h5", "fields/step_a.h5.tmp",
      "checkpoint/mine.txt", "particles/rocks.h5", "figures/one.png"};
  for (const std::string& name : others) {
    fs::create_directories(fs::path(out + "/" + name).parent_path());
    test::write_text(out + "/" + name, "mine");
  }
  ASSERT_EQ(run_channel(out, "--overwrite --steps 200").exit_code, 0);
  for (const std::string& name : others) EXPECT_EQ(test::contents(out + "/" + name), "mine") << name;
  EXPECT_EQ(rows_of(out), 3);
  EXPECT_FALSE(fs::exists(out + "/fields/step_000000000300.h5"));
  EXPECT_FALSE(fs::exists(out + "/checkpoint/step_000000001000.checkpoint"));
  EXPECT_EQ(run_channel(out, "--resume").exit_code, 0);
  for (const std::string& name : others) EXPECT_EQ(test::contents(out + "/" + name), "mine") << name;
  EXPECT_EQ(rows_of(out), 11);
}

TEST(RunFolder, IsOverwrittenWithItsErrorBars) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", few = "--overwrite --quiet --steps 100 ";
  for (const std::string& run : {out, out + "/error_bars/coarse"})  // as --error-bars leaves them
    ASSERT_EQ(run_channel(run, few).exit_code, 0);
  test::write_text(out + "/error_bars.csv", "time_s\n");
  test::write_text(out + "/error_bars/coarse/notes.txt", "mine");
  fs::create_directories(out + "/error_bars/finer");
  test::write_text(out + "/error_bars/finer/run.json", "mine");
  ASSERT_EQ(run_channel(out, few + "--set flow.viscosity=2e-6").exit_code, 0);
  std::vector<std::string> left;
  for (const auto& [path, text] : files_of(out + "/error_bars")) left.push_back(path.substr(out.size()));
  EXPECT_THAT(left, testing::ElementsAre("/error_bars/coarse/notes.txt", "/error_bars/finer/run.json"));
  EXPECT_FALSE(fs::exists(out + "/error_bars.csv"));
}

TEST(RunFolder, WithFilesOfAnotherProgramIsRefused) {
  const TemporaryFolder folder;
  for (const std::string name : {"history.csv", "fields.h5", "fields/step_000000000100.h5"}) {
    const std::string out = folder / "out";
    fs::create_directories(fs::path(out + "/" + name).parent_path());
    test::write_text(out + "/" + name, "mine");
    for (const char* use : {"", "--overwrite"}) expect_refused(run_channel(out, use), name + ": is in the way");
    EXPECT_EQ(test::contents(out + "/" + name), "mine");
    fs::remove_all(out);
  }
  test::write_text(folder / "run.json", "{\n  \"status\": \"fine\"\n}\n");
  for (const char* use : {"", "--overwrite", "--resume"})
    expect_refused(run_channel(folder.path(), use), "run.json: is no record");
  EXPECT_EQ(test::contents(folder / "run.json"), "{\n  \"status\": \"fine\"\n}\n");
}

TEST(RunFolder, ServesOneProcessAtATimeAndNamesIt) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  test::BackgroundVug first("run " + channel + " --quiet --threads 1 --set time.steps=1000000000 -o " + out,
                            folder / "log");
  ASSERT_TRUE(first.wait_for_file(out + "/fields.xdmf")) << first.log();
  const std::string name = "out: is in use by process " + std::to_string(first.pid()) + " on ";
  for (const char* use : {"", "--overwrite", "--resume"}) expect_refused(run_channel(out, use), name);
  expect_refused(run_vug(small_lab + out), name);
  first.signal(SIGKILL);
  EXPECT_EQ(first.wait(), 128 + SIGKILL);
  expect_refused(run_channel(out, ""), "holds a run (unfinished");
  EXPECT_EQ(run_channel(out, "--overwrite").exit_code, 0) << "the lock ended with its holder";
}

/// Who clears a folder under a run and starts another there has the other: the first one ends and says so.
TEST(RunFolder, ThatWasRemovedUnderARunIsNoLongerItsOwn) {
  for (const char* const name : {"", "/run.lock", "/history.csv"}) {
    const TemporaryFolder folder;
    const std::string out = folder / "out", gone = name;
    test::BackgroundVug first("run " + channel + " --quiet --threads 1 --set time.steps=1000000000 " +
                                  "--set output.interval_steps=20000 -o " + out,
                              folder / "log");
    ASSERT_TRUE(first.wait_for_file(out + "/checkpoint/step_000000020000.checkpoint")) << first.log();
    std::filesystem::rename(out + gone, folder / "gone");
    if (gone.empty()) {
      EXPECT_EQ(run_channel(out, "--quiet").exit_code, 0);
    }
    EXPECT_EQ(first.wait(), 4) << gone;
    if (gone.empty()) {
      EXPECT_THAT(test::contents(out + "/run.json"), testing::HasSubstr("\"steps\": 1000,"));
    } else {
      EXPECT_THAT(first.log(), testing::HasSubstr("was removed or replaced while the run wrote there"));
    }
  }
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
  ASSERT_EQ(run_channel(folder / "alone", "--quiet").exit_code, 0);
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

}  // namespace
}  // namespace vug
