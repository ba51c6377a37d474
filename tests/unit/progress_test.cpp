#include "io/progress.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace vug {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

struct Stopwatch {
  double now = 100;
  std::ostringstream out;
  std::function<double()> clock() {
    return [this] { return now; };
  }
  auto lines() const {
    const auto text = out.str();
    return std::count(text.begin(), text.end(), '\n');
  }
};

// 1000 steps of 1e-6 s with 2e6 updates each, 0.1 s a step: 10 steps/s, 20 MLUPS, 100 s in all.
const Progress::Run hundred_seconds{0, 1000, 1e-6, 2e6};

TEST(Progress, SaysTimeSpeedAndWhatIsLeft) {
  Stopwatch watch;
  Progress progress(watch.out, false, hundred_seconds, watch.clock());
  for (int step = 1; step <= 500; ++step) {
    watch.now += 0.1;
    progress.update(step);
  }
  EXPECT_NEAR(progress.steps_per_second(), 10, 1e-6);
  EXPECT_NEAR(progress.mlups(), 20, 1e-6);
  EXPECT_THAT(watch.out.str(), HasSubstr(" 50 %  t = 0.0005 of 0.001 s  step 500  10 steps/s  20.0 MLUPS  ETA 50 s"));
}

/// A line that wraps would stay when the next one is drawn over its last row.
TEST(Progress, FitsOnATerminal) {
  for (const int columns : {40, 80, 100, 200}) {
    Stopwatch watch;
    Progress progress(watch.out, true, hundred_seconds, watch.clock(), [&] { return columns; });
    for (int step = 1; step <= 500; ++step) {
      watch.now += 0.1;
      progress.update(step);
    }
    std::istringstream drawn(watch.out.str());
    std::size_t longest = 0;
    for (std::string line; std::getline(drawn, line, '\r');) longest = std::max(longest, line.size());
    EXPECT_LE(longest, static_cast<std::size_t>(columns - 1) + 3) << "with the 3 that clear the line";
    EXPECT_GT(longest, columns < 100 ? columns - 2u : 70u);
    EXPECT_EQ(watch.out.str().find("[#") != std::string::npos, columns >= 100) << columns;
  }
}

TEST(Progress, IsPlainAndShortInALog) {
  Stopwatch watch;
  Progress progress(watch.out, false, hundred_seconds, watch.clock());
  for (int step = 1; step <= 1000; ++step) {
    watch.now += 0.1;
    progress.update(step);
  }
  EXPECT_EQ(watch.lines(), 20) << watch.out.str();  // every 5 %
  EXPECT_THAT(watch.out.str(), Not(HasSubstr("\r")));
  EXPECT_THAT(watch.out.str(), Not(HasSubstr("\x1b")));
}

TEST(Progress, AddsFewLinesToTheLogOfALongRun) {
  Stopwatch watch;
  Progress progress(watch.out, false, {0, 100000000, 1e-7, 1e6}, watch.clock());
  for (int step = 1; step <= 36000; ++step) {  // an hour, far from 5 %
    watch.now += 0.1;
    progress.update(step);
  }
  EXPECT_GE(watch.lines(), 60);
  EXPECT_LE(watch.lines(), 70);
}

TEST(Progress, EstimatesFromTheLastHalfMinute) {
  Stopwatch watch;
  Progress progress(watch.out, false, {0, 100000, 1e-6, 1e6}, watch.clock());
  std::int64_t step = 0;
  for (int i = 0; i < 1000; ++i) watch.now += 1, progress.update(++step);   // one a second
  for (int i = 0; i < 400; ++i) watch.now += 0.1, progress.update(++step);  // then ten a second
  EXPECT_NEAR(progress.steps_per_second(), 10, 0.5);
}

TEST(Progress, RedrawsOneLineOnATerminal) {
  Stopwatch watch;
  Progress progress(watch.out, true, hundred_seconds, watch.clock());
  for (int step = 1; step <= 100; ++step) {
    watch.now += 0.01;
    progress.update(step);
  }
  const auto text = watch.out.str();
  EXPECT_EQ(watch.lines(), 0);
  const auto redraws = std::count(text.begin(), text.end(), '\r');
  EXPECT_GE(redraws, 4);  // five a second, during one second
  EXPECT_LE(redraws, 5);
  EXPECT_THAT(text, HasSubstr("[#"));
  progress.note("first crack");
  EXPECT_THAT(watch.out.str(), HasSubstr("\r\x1b[Kfirst crack\n"));
  progress.finish("done");
  EXPECT_EQ(watch.lines(), 2);
}

TEST(Progress, IsWarningsOnlyWhereItIsQuiet) {
  Stopwatch watch;
  Progress::Run quiet = hundred_seconds;
  quiet.quiet = true;
  Progress progress(watch.out, false, quiet, watch.clock());
  watch.now += 100;
  progress.update(1000);
  progress.note("step 7, 1 s: 10 bonds have failed");
  progress.note("warning: too fast");
  progress.note("step 7, 1 s: warning: too far");
  progress.finish("done");
  EXPECT_EQ(watch.out.str(), "warning: too fast\nstep 7, 1 s: warning: too far\n");
}

TEST(Progress, CountsAResumedRunFromItsFirstStep) {
  Stopwatch watch;
  Progress progress(watch.out, false, {600, 1000, 1e-6, 2e6}, watch.clock());
  watch.now += 10;
  progress.update(700);
  EXPECT_THAT(watch.out.str(), HasSubstr(" 70 %"));
  EXPECT_THAT(watch.out.str(), HasSubstr("ETA 30 s"));
  progress.finish("interrupted");
  EXPECT_THAT(watch.out.str(), HasSubstr("interrupted at t = 0.0007 s, step 700: 100 steps in 10 s, 20.0 MLUPS"));
}

}  // namespace
}  // namespace vug
