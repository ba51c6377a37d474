// A run that a launcher or taskset leaves fewer processors than it has threads says so.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sched.h>
#include <unistd.h>

namespace vug {
namespace {

/// This process, and what it starts, on one processor.
struct OnOneProcessor {
  OnOneProcessor() {
    sched_getaffinity(0, sizeof before, &before);
    int first = 0;
    while (!CPU_ISSET(first, &before)) ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  OnOneProcessor(const OnOneProcessor&) = delete;
  OnOneProcessor& operator=(const OnOneProcessor&) = delete;
  ~OnOneProcessor() { sched_setaffinity(0, sizeof before, &before); }
  cpu_set_t before;
};

std::string said_with(const char* threads) {
  const test::TemporaryFolder folder;
  const test::Outcome run = test::run_vug("run " VUG_SOURCE_DIR "/cases/tutorial/channel.toml --quiet --steps 2 -o " +
                                          (folder / "out") + " --threads " + threads);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  return run.output;
}

TEST(Processors, FewerThanThreadsAreTold) {
  if (sysconf(_SC_NPROCESSORS_ONLN) < 2) GTEST_SKIP() << "there is one processor";
  const OnOneProcessor here;
  EXPECT_THAT(said_with("2"), testing::HasSubstr("warning: threads: 2 on 1 processor that they may use"));
  EXPECT_THAT(said_with("1"), testing::Not(testing::HasSubstr("threads")));
}

/// With the control groups of a container, in a name space of its own in which they lie over those of this system.
TEST(Processors, AreNoMoreThanAContainerGrants) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "list", "0::/\n");
  std::filesystem::create_directory(folder / "tree");
  test::write_text(folder / "tree/cpu.max", "100000 100000\n");
  const auto within = [&](const std::string& command) {
    return test::run_command("unshare --mount --map-root-user sh -c 'mount --bind " + (folder / "list") +
                             " /proc/$$/cgroup && mount --bind " + (folder / "tree") + " /sys/fs/cgroup && exec " +
                             command + "'");
  };
  if (within("true").exit_code != 0) GTEST_SKIP() << "nobody may mount here";
  if (sysconf(_SC_NPROCESSORS_ONLN) < 2 || test::run_vug("info").output.find("OpenMP") == std::string::npos)
    GTEST_SKIP() << "there is one processor";
  const std::string vug = "env -u OMP_NUM_THREADS " VUG_EXECUTABLE " ";
  EXPECT_THAT(
      within(vug + "info").output,
      testing::ContainsRegex("threads: 1 instead of [0-9]+: the control group .* grants the time of 1 processor; "
                             "--threads insists"));
  const std::string run = vug + "run " VUG_SOURCE_DIR "/cases/tutorial/channel.toml --quiet --steps 2 -o " +
                          (folder / "out") + " --threads 2";
  EXPECT_THAT(within(run).output, testing::HasSubstr("warning: threads: 2 on 1 processor that they may use"));
  test::write_text(folder / "study.toml",
                   "[study]\ncase = \"" + std::filesystem::absolute(VUG_SOURCE_DIR "/cases/poiseuille.toml").string() +
                       "\"\nset = [\"time.steps=20\", \"output.interval_steps=10\"]\n[[study.keys]]\nkey = "
                       "\"flow.viscosity\"\nvalues = [1e-6, 2e-6]\n");
  EXPECT_THAT(within(vug + "sweep " + (folder / "study.toml") + " -o " + (folder / "study")).output,
              testing::HasSubstr("2 runs, 2 of them to do, 1 at once"));
}

}  // namespace
}  // namespace vug
