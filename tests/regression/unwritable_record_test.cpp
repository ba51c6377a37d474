// A run says why it ended, with its exit code, also where its record cannot be written.
#include "support/background_vug.hpp"
#include "support/run_vug.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <string>

namespace vug {
namespace {

using test::TemporaryFolder;
using testing::HasSubstr;

/// Replaces the record of a run that goes on by a folder, over which none can be written.
void block_record(const test::BackgroundVug& vug, const std::string& out) {
  vug.signal(SIGSTOP);
  std::filesystem::remove(out + "/run.json");
  std::filesystem::create_directories(out + "/run.json/full");
  vug.signal(SIGCONT);
}

TEST(ExitCodes, WhyARunEndedIsSaidWhereItsRecordCannotBeWritten) {
  const TemporaryFolder folder;
  test::write_text(folder / "case.toml",
                   "[lattice]\nsize = [0.03, 0.01]\nspacing = 1e-3\ntime_step = 1e-3\n[time]\nsteps = 1000000000\n"
                   "[flow]\nviscosity = 2e-6\n[boundary.left]\nflow = { type = \"velocity\", "
                   "velocity = [[0, 0, 0], [80, 0, 0], [90, 0.49, 0]] }\n"
                   "[boundary.right]\nflow = { type = \"pressure\", pressure = 1e5 }\n[output]\ninterval = 1e5\n");
  const std::string out = folder / "out";
  test::BackgroundVug run("run " + (folder / "case.toml") + " --quiet --threads 1 -o " + out, folder / "log");
  ASSERT_TRUE(run.wait_for_file(out + "/run.json")) << run.log();
  block_record(run, out);
  EXPECT_EQ(run.wait(), 3) << run.log();
  EXPECT_THAT(run.log(), HasSubstr("vug: flow diverged at step"));
}

TEST(ExitCodes, WhyALaboratoryTestEndedIsSaidWhereItsRecordCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string out = folder / "out";
  test::BackgroundVug run("lab " VUG_SOURCE_DIR
                          "/cases/laboratory/compression.toml --quiet --threads 1 "
                          "--set laboratory.platen_speed=1e-3 -o " +
                              out,
                          folder / "log");
  ASSERT_TRUE(run.wait_for_file(out + "/run.json")) << run.log();
  block_record(run, out);
  run.signal(SIGTERM);
  EXPECT_EQ(run.wait(), 130) << run.log();
  EXPECT_THAT(run.log(), HasSubstr("vug: interrupted by SIGTERM"));
}

}  // namespace
}  // namespace vug
