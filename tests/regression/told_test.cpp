// What a run tells while nothing is wrong, and what a check does.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace vug {
namespace {

using test::Outcome;
using test::run_command;
using test::run_vug;
using test::small_rock;
using test::TemporaryFolder;
using testing::HasSubstr;

TEST(Events, AreToldInTheLogAndInTheRecord) {
  const TemporaryFolder folder;
  const Outcome outcome = run_vug("run " + small_rock + " --threads 1 -o " + (folder / "out"));
  ASSERT_EQ(outcome.exit_code, 0);
  const std::string record = test::contents((folder / "out") + "/run.json");
  for (const char* news : {"bonds have failed", "nodes have dissolved", "nodes have been opened by damage"}) {
    EXPECT_THAT(outcome.output, HasSubstr(news));
    EXPECT_THAT(record, HasSubstr(news));
  }
  // of what there was before a restart nothing is told again
  const Outcome first = run_vug("run " + small_rock + " --threads 1 --steps 390 -o " + (folder / "parts"));
  EXPECT_THAT(first.output, HasSubstr(" bonds have failed"));
  const Outcome rest = run_vug("run " + small_rock + " --threads 1 --resume -o " + (folder / "parts"));
  EXPECT_EQ(rest.exit_code, 0);
  EXPECT_THAT(rest.output, HasSubstr("done at"));
  EXPECT_THAT(rest.output, testing::Not(HasSubstr(" have ")));  // ten steps: no count gains a digit
}

TEST(Check, ReportsWithoutWriting) {
  const TemporaryFolder folder;
  const Outcome outcome = run_command("root=$PWD; cd " + folder.path() +
                                      " && OMP_PROC_BIND=false $root/" VUG_EXECUTABLE " check $root/" + small_rock);
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* expected : {"relaxation time tau_f", "sub-steps per lattice step", "bytes per node", "fluid nodes"})
    EXPECT_THAT(outcome.output, HasSubstr(expected));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  const Outcome json =
      run_command("OMP_PROC_BIND=false " VUG_EXECUTABLE " check --json " + small_rock +
                  " | " VUG_PYTHON " -c \"import json, sys; r = json.load(sys.stdin); print(r['nx'], r['ny'])\"");
  EXPECT_EQ(json.output, "80 56\n");
}

}  // namespace
}  // namespace vug
