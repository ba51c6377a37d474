#include "host/idle_processors.hpp"

#include <gtest/gtest.h>

namespace vug {
namespace {

// user nice system idle iowait irq softirq steal guest guest_nice, after proc(5)
const char* const before =
    "cpu  300 0 30 2000 10 0 0 0 0 0\n"
    "cpu0 100 0 10 900 5 0 0 0 50 0\n"
    "cpu1 200 0 20 1100 5 0 0 0 0 0\n"
    "intr 123 4 5\n";

std::vector<ProcessorTime> later(int idle0, int idle1, int stolen1 = 0) {
  return {{0, 905 + idle0, 1015 + 20}, {1, 1105 + idle1, 1325 + 20 + stolen1}};
}

TEST(IdleProcessors, ReadsTheTimesOfEachProcessor) {
  const std::vector<ProcessorTime> times = read_processor_times(before);
  ASSERT_EQ(times.size(), 2u);
  EXPECT_EQ(times[1].processor, 1);
  EXPECT_EQ(times[0].idle, 905);
  EXPECT_EQ(times[0].all, 1015) << "what guests use is in user time already";
  EXPECT_EQ(times[1].all, 1325);
  EXPECT_TRUE(read_processor_times("no such file").empty());
}

TEST(IdleProcessors, AddsUpWhatIsIdleAndRounds) {
  const std::vector<ProcessorTime> times = read_processor_times(before);
  EXPECT_EQ(idle_processors(times, later(20, 20)), 2);
  EXPECT_EQ(idle_processors(times, later(20, 13)), 2) << "a third of a processor is no reason";
  EXPECT_EQ(idle_processors(times, later(20, 0)), 1);
  EXPECT_EQ(idle_processors(times, later(0, 0)), 1) << "one thread there always is";
  EXPECT_EQ(idle_processors(times, later(10, 20, 20)), 1)
      << "half of one is taken by another program, and half by the host";
  EXPECT_EQ(idle_processors(times, times), 2) << "no time has passed";
}

}  // namespace
}  // namespace vug
