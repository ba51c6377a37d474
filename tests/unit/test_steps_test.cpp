// Laboratory tests so slow that no int counts the steps between two points of their curves.
#include "dem/test_steps.hpp"

#include "dem/laboratory.hpp"
#include "dem/quench.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <limits>
#include <thread>

namespace vug {
namespace {

/// Asks for a stop after a while, and takes that back when it ends.
class StopSoon {
 public:
  StopSoon()
      : asking_([] {
          std::this_thread::sleep_for(std::chrono::milliseconds(200));
          request_stop(SIGTERM);
        }) {}
  StopSoon(const StopSoon&) = delete;
  StopSoon& operator=(const StopSoon&) = delete;
  ~StopSoon() {
    asking_.join();
    request_stop(0);
  }

 private:
  std::thread asking_;
};

/// Until the stop some hundred steps are taken; the first point of the curve is years away.
void expect_no_point_soon(PlatenTest test) {
  test.sample_strain = 1e-3;
  const StopSoon stop;
  int points = 0;
  EXPECT_THROW(load_between_platens(Exec(), test::block(0.01, 0.01, 0.005, 0), {}, test,
                                    [&](const Mechanics&, const PlatenResult&, bool) { ++points; }),
               Interrupted);
  EXPECT_EQ(points, 0);
}

TEST(TestSteps, OfASlowPressAreAllTaken) {
  PlatenTest test;
  test.speed = 1e-12;
  expect_no_point_soon(test);
}

TEST(TestSteps, OfSlowHeatingAreAllTaken) {
  PlatenTest test;
  test.speed = 0;
  test.heating_rate = 1e-6;
  expect_no_point_soon(test);
}

TEST(TestSteps, OfASlowQuenchAreAllTaken) {
  QuenchTest test;
  test.duration = 1e5;
  test.samples = 10;
  const StopSoon stop;
  int temperatures = 0;
  EXPECT_THROW(quench(Exec(), test::block(0.01, 0.01, 0.002, 0), {}, test,
                      [&](const Mechanics&, double, bool) { ++temperatures; }),
               Interrupted);
  EXPECT_EQ(temperatures, 0);
}

TEST(TestSteps, AreCountedBeyondTheRangeOfAnInt) {
  EXPECT_EQ(whole_steps(0.3, "a"), 1);
  EXPECT_EQ(whole_steps(2.3e12, "a"), 2300000000000);
  EXPECT_THROW(whole_steps(1e16, "a"), InputError);
  EXPECT_THROW(whole_steps(std::numeric_limits<double>::infinity(), "a"), InputError);
  EXPECT_THROW(whole_steps(std::numeric_limits<double>::quiet_NaN(), "a"), InputError);
}

/// To the bit.
TEST(TestSteps, InPiecesMoveTheRockAsAtOnce) {
  Loads pull;
  pull.traction[static_cast<std::size_t>(RockSide::top)] = {0, 1e6};
  pull.support[static_cast<std::size_t>(RockSide::bottom)] = Support::roller;
  const Assembly rock = test::block(0.01, 0.01, 0.005, 0);
  Mechanics pieces(rock, {}, pull), whole(rock, {}, pull);
  const double dt = 0.3 * whole.critical_step();
  advance_long(Exec(), pieces, dt, 4123);
  whole.advance(Exec(), dt, 4123);
  EXPECT_EQ(pieces.steps(), whole.steps());
  EXPECT_EQ(pieces.time(), whole.time());
  const auto u = test::host_copy(pieces.particles().u), v = test::host_copy(whole.particles().u);
  for (std::size_t i = 0; i < u.extent(0); ++i) EXPECT_EQ(u(i, 1), v(i, 1));
}

/// Rock that is pulled slowly would sleep, and break at another stress.
TEST(TestSteps, LetNoRockSleep) {
  const auto curve = [](double rest_tolerance) {
    MechanicsParameters parameters;
    parameters.rest_tolerance = rest_tolerance;
    PlatenTest test;
    test.speed = -0.02;
    test.largest_strain = 2e-4;
    return load_between_platens(Exec(), test::block(0.02, 0.02, 0.002, 0.2), parameters, test).stress;
  };
  const std::vector<double> awake = curve(0);
  EXPECT_GT(awake.size(), 10u);
  EXPECT_EQ(curve(1), awake);
}

TEST(TestSteps, LetNoRockSleepInAQuench) {
  const auto push = [](double rest_tolerance) {
    MechanicsParameters parameters;
    parameters.rest_tolerance = rest_tolerance;
    QuenchTest test;
    test.drop = 1;
    test.samples = 10;
    test.duration = 1e-4;
    double share = 0;
    quench(Exec(), test::block(0.02, 0.02, 0.002, 0.2), parameters, test,
           [&](const Mechanics& rock, double, bool) { share += rock.awake_share() / 10; });
    return share;
  };
  EXPECT_EQ(push(1), push(0));
}

}  // namespace
}  // namespace vug
