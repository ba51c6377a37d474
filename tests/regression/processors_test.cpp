// A run that a launcher or taskset leaves fewer processors than it has threads says so.
#include "support/run_vug.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace vug
