// Flow that is held once it is steady (accuracy.flow_tolerance).
#include "support/channel_with_pixel.hpp"
#include "support/coupled_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::channel_with_pixel;

/// Runs n steps with the checks that `vug run` makes.
void steps(test::CoupledRun& run, int n) {
  for (int step = 0; step < n; step += 20) run.steps(20);
}

/// Runs until the flow is held, for 150 000 steps at most.
void run_until_held(test::CoupledRun& run) {
  for (int look = 0; look < 1500 && run.now("flow_held_steps_1") == 0; ++look) run.steps(100);
  EXPECT_GT(run.now("flow_held_steps_1"), 0);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(HeldFlow, IsHeldOnceItIsSteadyAndNotBeforeThePressureIsRaised) {
  test::CoupledRun always(channel_with_pixel), held(channel_with_pixel, {"accuracy.flow_tolerance=1e-5"});
  steps(held, 500);
  EXPECT_EQ(held.now("flow_held_steps_1"), 0);
  steps(held, 3500);
  steps(always, 4000);
  EXPECT_GT(held.now("flow_held_steps_1"), 1000);
  const auto exact = always.nodes("velocity"), found = held.nodes("velocity");
  const double speed = largest_difference(exact, std::vector<double>(exact.size(), 0));
  // it decays by a tenth or more between two looks, so what was still to come is ten times the last change at most
  EXPECT_LE(largest_difference(exact, found), 1e-4 * speed);
  EXPECT_LE(largest_difference(always.nodes("concentration_A"), held.nodes("concentration_A")), 1e-3 * 1000);
  EXPECT_LE(std::abs(held.now("fluid_mass_balance_error_1")), 1e-13);
  EXPECT_LE(std::abs(held.now("A_balance_error_1")), 1e-13);
}

/// Pressure spreads along a narrow channel of L x n cells by diffusion, with K = c_s^2 n^2/(12 nu): in 100 steps next
/// to nothing of what is still to come. Held when both ends carry the same, in single precision as well, where changes
/// soon drown in rounding.
TEST(HeldFlow, IsHeldInALongNarrowChannelOnlyWhenBothEndsCarryTheSame) {
  const std::string narrow = R"(
[lattice]
size = [0.3, 0.004]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 200000
[flow]
viscosity = 5e-4
initial_pressure = 0
[boundary.left]
flow = { type = "pressure", pressure = 22.5 }
[boundary.right]
flow = { type = "pressure", pressure = 0 }
)";
  for (const std::string precision : {"double", "single"}) {
    test::CoupledRun run(narrow, {"accuracy.flow_tolerance=1e-3", "accuracy.precision=" + precision});
    run_until_held(run);
    const auto velocity = run.nodes("velocity");
    double in = 0, out = 0;
    for (std::size_t y = 0; y < 4; ++y) {
      in += velocity[2 * (300 * y)];
      out += velocity[2 * (300 * y + 299)];
    }
    // a Poiseuille flow of 2e-4 cells per step, 1/(2 n^2) more on the lattice; ends in error +t and -t
    const double exact = 4 * 2e-4 * (1 + 1 / 32.0);
    EXPECT_NEAR(in / exact, 1, 2e-3) << precision;
    EXPECT_NEAR(out / exact, 1, 2e-3) << precision;
  }
}

/// The narrow channel fills in some thousand steps, the wide one in some hundred, and is 256 times as fast.
TEST(HeldFlow, IsHeldOnlyWhenAPoreThatIsFarSlowerThanAnotherIsSteadyToo) {
  const std::string two_channels = R"(
[lattice]
size = [0.04, 0.018]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 200000
[geometry]
type = "shapes"
background = "fluid"
[[geometry.shapes]]
type = "rectangle"
from = [0, 1e-3]
to = [0.04, 2e-3]
material = "solid"
[flow]
viscosity = 1.66667e-4
initial_pressure = 0
[boundary.left]
flow = { type = "pressure", pressure = 1 }
[boundary.right]
flow = { type = "pressure", pressure = 0 }
)";
  for (const std::string precision : {"double", "single"}) {
    test::CoupledRun run(two_channels, {"accuracy.flow_tolerance=1e-3", "accuracy.precision=" + precision});
    run_until_held(run);
    const auto velocity = run.nodes("velocity");
    const double exact = 1 / 0.04 / 1000 * 1e-6 / (12 * 1.66667e-4) * (1 + 0.5);  // dp/L n^2/(12 mu), on the lattice
    for (const std::size_t x : {0, 20, 39}) EXPECT_NEAR(velocity[2 * x] / exact, 1, 3e-3) << precision << ' ' << x;
  }
}

/// Nothing crosses a boundary: only how changes shrink tells what is still to come.
TEST(HeldFlow, IsHeldBesideASlidingWallOnlyWhenAllFluidFollowsIt) {
  const std::string couette = R"(
[lattice]
size = [0.004, 0.04]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 200000
[flow]
viscosity = 2e-5
[boundary.left]
flow = { type = "periodic" }
[boundary.right]
flow = { type = "periodic" }
[boundary.top]
flow = { type = "wall", velocity = [0.01, 0] }
)";
  test::CoupledRun run(couette, {"accuracy.flow_tolerance=1e-3"});
  run_until_held(run);
  const auto velocity = run.nodes("velocity");
  for (std::size_t y = 0; y < 40; ++y)
    EXPECT_NEAR(velocity[2 * 4 * y], 0.01 * (static_cast<double>(y) + 0.5) / 40, 1.5e-3 * 0.01) << y;
}

/// A tolerance below what rounding leaves of the velocity: what changes no more but for that is steady.
TEST(HeldFlow, IsHeldInSinglePrecisionWhateverTheTolerance) {
  test::CoupledRun always(channel_with_pixel),
      held(channel_with_pixel, {"accuracy.flow_tolerance=1e-9", "accuracy.precision=single"});
  steps(always, 8000);
  steps(held, 8000);
  EXPECT_GT(held.now("flow_held_steps_1"), 1000);
  const auto exact = always.nodes("velocity"), found = held.nodes("velocity");
  const double speed = largest_difference(exact, std::vector<double>(exact.size(), 0));
  EXPECT_LE(largest_difference(exact, found), 1e-4 * speed);
}

/// Steady for 3 s, and held only once the last value of the table is reached.
TEST(HeldFlow, IsNotHeldBeforeARateHasItsLastValue) {
  for (const std::string given :
       {"flow_rate = [[0, 2e-5], [3, 2e-5], [3.2, 4e-5]]", "mass_flow_rate = [[0, 0.02], [3, 0.02], [3.2, 0.04]]"}) {
    test::CoupledRun run(
        channel_with_pixel,
        {"accuracy.flow_tolerance=1e-4", "output.flows=true", "reaction.rate_constant=0",
         "boundary.left.flow={ type = \"velocity\", " + given + " }", "boundary.right.flow={ type = \"outflow\" }"});
    steps(run, 3000);
    EXPECT_EQ(run.now("flow_held_steps_1"), 0) << given;
    EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s"), 0.02, 1e-12) << given;
    steps(run, 4000);
    EXPECT_GT(run.now("flow_held_steps_1"), 0) << given;
    EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s"), 0.04, 1e-12) << given;
  }
}

/// A jump within the last lattice step before a look: the look sees the flow from before it.
TEST(HeldFlow, IsNotHeldBeforeTheFlowHasSeenItsLastValue) {
  for (const auto& [interval, time] : {std::pair{"20", 2.0}, {"1", 1.997}})
    for (const std::string jump : {"velocity = [[0, 1e-3, 0], [{0}, 1e-3, 0], [{1}, 2e-3, 0]]",
                                   "pressure = [[0, 10.0], [{0}, 10.0], [{1}, 20.0]]"}) {
      const std::string given = fmt::format(fmt::runtime(jump), time - 1e-4, time);
      const bool pressure = given.starts_with("pressure");
      test::CoupledRun run(
          channel_with_pixel,
          {"accuracy.flow_tolerance=1e-3", std::string("accuracy.guard_interval=") + interval,
           "reaction.rate_constant=0", "flow.initial_pressure=0",
           std::string("boundary.left.flow={ type = \"") + (pressure ? "pressure" : "velocity") + "\", " + given + " }",
           "boundary.right.flow={ type = \"pressure\", pressure = 0 }"});
      steps(run, 1980);
      const double before = run.now("mean_velocity_x_m/s");
      steps(run, 4000);
      EXPECT_GT(run.now("flow_held_steps_1"), 0) << given;
      EXPECT_NEAR(run.now("mean_velocity_x_m/s") / before, 2, 0.02) << given << ", looks every " << interval;
    }
}

TEST(HeldFlow, WakesWhenAPixelDissolves) {
  test::CoupledRun always(channel_with_pixel), held(channel_with_pixel, {"accuracy.flow_tolerance=1e-4"});
  const double nodes = held.now("fluid_nodes_1");
  int n = 0;
  for (; n < 60000 && held.now("fluid_nodes_1") < nodes + 6; n += 20) held.steps(20);
  ASSERT_LT(n, 60000);
  const double passed = held.now("flow_held_steps_1");
  EXPECT_GT(passed, 0.5 * n);
  steps(held, 40);
  EXPECT_EQ(held.now("flow_held_steps_1"), passed);  // two looks at least
  steps(always, n + 40);
  EXPECT_NEAR(held.now("dissolved_volume_m3_per_m") / always.now("dissolved_volume_m3_per_m"), 1, 1e-3);
  EXPECT_LE(std::abs(held.now("A_balance_error_1")), 1e-13);
}

TEST(HeldFlow, HasItsBitsWhateverElseIsLookedAt) {
  test::CoupledRun run(channel_with_pixel, {"accuracy.flow_tolerance=1e-5"}),
      looked_at(channel_with_pixel, {"accuracy.flow_tolerance=1e-5"});
  steps(run, 4000);
  for (int step = 0; step < 4000; step += 10) looked_at.steps(10);  // guards between the looks
  EXPECT_EQ(run.nodes("velocity"), looked_at.nodes("velocity"));
  EXPECT_EQ(run.nodes("concentration_A"), looked_at.nodes("concentration_A"));
}

}  // namespace
}  // namespace vug
