// Standard streams that are closed, full, or a pipe that nobody reads: results stay whole, and what could not be said
// is told by the exit code.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace vug {
namespace {

using test::run_command;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::string channel = VUG_SOURCE_DIR "/cases/poiseuille.toml --threads 1";

/// Exit code of vug with its streams redirected as a shell says.
int code_of(const std::string& arguments, const std::string& streams) {
  return run_command("( OMP_PROC_BIND=false " VUG_EXECUTABLE " " + arguments + " " + streams + " )").exit_code;
}

/// As code_of, with a pipe in place of stream `number` that nobody reads.
int code_with_broken_pipe(const std::string& arguments, int number) {
  return run_command(
             "OMP_PROC_BIND=false " VUG_PYTHON
             " -c \"import os, subprocess, sys; r, w = os.pipe(); os.close(r); "
             "sys.exit(subprocess.run(['" VUG_EXECUTABLE "'] + sys.argv[1:], stdin=subprocess.DEVNULL, " +
             std::string(number == 1 ? "stdout=w, stderr=subprocess.DEVNULL" : "stdout=subprocess.DEVNULL, stderr=w") +
             ").returncode)\" " + arguments)
      .exit_code;
}

struct Command {
  std::string arguments;
  int code;    ///< with all streams in order
  bool tells;  ///< it has something to say on the standard output
};

TEST(Streams, ClosedFullAndBrokenGiveTheExitCodeThatIsDue) {
  const TemporaryFolder folder;
  const std::string lab = "lab " VUG_SOURCE_DIR
                          "/cases/laboratory/compression.toml --quiet --set laboratory.size=[0.015,0.03] --set "
                          "laboratory.platen_speed=2 --set rock.element_size=3e-3 --set laboratory.largest_strain=3e-4";
  const std::vector<Command> commands{
      {"run " + channel + " --steps 200 --overwrite -o " + (folder / "run"), 0, false},
      {"check " + channel, 0, true},
      {"check --json " + channel, 0, true},
      {lab + " --overwrite -o " + (folder / "lab"), 0, true},
      {"info", 0, true},
      {"--help", 0, true},
      {"run " VUG_SOURCE_DIR "/tests/cases/broken/unknown_key.toml -o " + (folder / "broken"), 2, false},
      {"check " VUG_SOURCE_DIR "/tests/cases/broken/unknown_key.toml", 2, false},
      {"walk", 2, false}};
  for (const Command& command : commands) {
    const int told = command.tells ? 4 : command.code;
    EXPECT_EQ(code_of(command.arguments, "<&-"), command.code) << command.arguments;
    EXPECT_EQ(code_of(command.arguments, ">&-"), told) << command.arguments;
    EXPECT_EQ(code_of(command.arguments, ">/dev/full"), told) << command.arguments;
    EXPECT_EQ(code_with_broken_pipe(command.arguments, 1), told) << command.arguments;
    EXPECT_EQ(code_of(command.arguments, "2>&-"), command.code) << command.arguments;
    EXPECT_EQ(code_of(command.arguments, "2>/dev/full"), command.code) << command.arguments;
    EXPECT_EQ(code_with_broken_pipe(command.arguments, 2), command.code) << command.arguments;
    EXPECT_EQ(code_of(command.arguments, "<&- >&- 2>&-"), told) << command.arguments;
  }
}

TEST(Streams, ThatAreClosedDoNotBecomeFilesOfTheRun) {
  const TemporaryFolder folder;
  const std::string run = "run " + channel + " --set output.interval_steps=500 -o ";
  ASSERT_EQ(code_of(run + (folder / "open"), ""), 0);
  for (const std::string closed : {"<&-", ">&-", "2>&-", "<&- >&- 2>&-"}) {
    const std::string out = folder / "closed";
    EXPECT_EQ(code_of(run + out, closed), 0);
    EXPECT_EQ(test::difference(folder / "open", out), "") << closed;
    std::filesystem::remove_all(out);
  }
}

TEST(Streams, ThatFailAreNamed) {
  const test::Outcome outcome =
      run_command("( OMP_PROC_BIND=false " VUG_EXECUTABLE " check " + channel + " 2>&1 >/dev/full )");
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_EQ(outcome.output, "vug: standard output: cannot write: No space left on device\n");
}

}  // namespace
}  // namespace vug
