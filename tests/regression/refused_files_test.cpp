// What the system will not do with a file is one line and exit code 4, in every command.
#include "support/channel_runs.hpp"

#include <gmock/gmock.h>

namespace vug {
namespace {

using test::run_command;
using test::run_vug;
using test::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;

void expect_failed(const test::Outcome& outcome, const std::string& reason) {
  EXPECT_EQ(outcome.exit_code, 4) << outcome.output;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr(reason));
}

TEST(RefusedFiles, WithNamesTooLong) {
  const TemporaryFolder folder;
  const std::string name = folder / std::string(300, 'a');
  expect_failed(run_vug("new channel " + name), "File name too long");
  expect_failed(run_vug("check " + test::channel + " --preview " + name + ".png"), "File name too long");
}

TEST(RefusedFiles, AreNoLackOfMemoryOfARun) {
  const TemporaryFolder folder;
  const std::string out = folder / "out", history = out + "/history.csv";
  ASSERT_EQ(test::run_channel(out, "--quiet --steps 100").exit_code, 0);
  fs::remove(history);
  fs::create_symlink("history.csv", history);
  expect_failed(run_vug("watch " + out), history + ": Too many levels of symbolic links");
  expect_failed(test::run_channel(out, "--quiet --resume"), history + ": Too many levels of symbolic links");
  EXPECT_THAT(test::contents(out + "/run.json"), HasSubstr("\"exit_code\": 4,"));
}

TEST(RefusedFiles, InAFolderThatIsGone) {
  const TemporaryFolder folder;
  const std::string study = folder / "study.toml";
  test::write_text(study, "[study]\ncase = \"" + fs::absolute(test::channel).string() +
                              "\"\n[[study.keys]]\nkey = \"flow.viscosity\"\nvalues = [1e-6]\n");
  fs::create_directory(folder / "gone");
  expect_failed(run_command("vug=$PWD/" VUG_EXECUTABLE "; cd " + (folder / "gone") +
                            " && rmdir ../gone && $vug sweep " + study + " --batch slurm"),
                "No such file or directory");
}

}  // namespace
}  // namespace vug
