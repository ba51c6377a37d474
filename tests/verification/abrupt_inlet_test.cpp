// A velocity that sets in at once: between it and rock one cell away, bounce-back on both sides keeps what alternates
// from step to step for ever.
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

/// A block one cell in front of the side; speeds in m/s are those in cells per step.
const std::string block_at_inlet = R"(
[lattice]
size = [0.016, 0.010]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0.001, 0.002]
to = [0.005, 0.008]
[flow]
viscosity = 1e-4
initial_pressure = 0
[boundary.left]
flow = { type = "velocity", velocity = [0.01, 0] }
[boundary.right]
flow = { type = "outflow" }
)";

constexpr double speed = 0.01;

/// Largest change of velocity in one step, in the column of nodes in front of the block.
double change_in_a_step(test::CoupledRun& run) {
  const auto before = run.nodes("velocity");
  run.steps(1);
  const auto after = run.nodes("velocity");
  double largest = 0;
  for (std::size_t i = 0; i < after.size(); ++i)
    if (std::isfinite(after[i])) largest = std::max(largest, std::abs(after[i] - before[i]));
  return largest;
}

/// The setting of what is given at the left.
std::string left(const std::string& given) {
  return "boundary.left.flow={ type = \"velocity\", " + given + " }";
}

const std::string jump = "velocity = [[0, 0.01, 0], [0.02, 0.01, 0], [0.021, 0.02, 0]]";

TEST(AbruptInlet, LeavesNothingThatAlternatesBeforeRockOneCellAway) {
  for (const std::string& given : {std::string("velocity = [0.01, 0]"), std::string("flow_rate = 1e-4"),
                                   std::string("mass_flow_rate = 0.1"), jump}) {
    test::CoupledRun run(block_at_inlet, {left(given)});
    run.steps(600);
    EXPECT_LE(change_in_a_step(run), 1e-4 * speed) << given;
  }
}

/// The same as if the value jumped from one step to the next. Nothing has reached the way out yet, so that the balance
/// tells what has entered.
TEST(AbruptInlet, LetsInAllThatIsGiven) {
  constexpr double in_a_step = 1000 * speed * 0.010 * 1e-3;  // kg/m
  const auto entered = [](const std::string& given) {
    test::CoupledRun run(block_at_inlet, {left(given), "lattice.size=[0.2, 0.010]"});
    run.steps(41);
    return run.gain("fluid_mass", "boundaries") / in_a_step;
  };
  EXPECT_NEAR(entered("velocity = [0.01, 0]"), 41, 1e-12);
  EXPECT_NEAR(entered("flow_rate = 1e-4"), 41, 1e-12);
  EXPECT_NEAR(entered("mass_flow_rate = 0.1"), 41, 1e-12);
  EXPECT_NEAR(entered(jump), 21 + 2 * 20, 1e-12);
}

/// In a closed box with odd numbers of rows and columns a swing of all fluid from step to step never decays.
TEST(AbruptBodyForce, LeavesNothingThatAlternatesInAClosedBox) {
  for (const char* collision : {"trt", "lallemand_luo", "bgk", "regularised"}) {
    test::CoupledRun run(
        "[lattice]\nsize = [0.007, 0.009]\nspacing = 1e-3\ntime_step = 1e-3\n[time]\nsteps = 9999\n"
        "[flow]\nviscosity = 3e-4\nbody_force = [0.1, -0.2]\n",
        {std::string("flow.collision=") + collision});
    run.steps(3000);
    EXPECT_LE(change_in_a_step(run), 1e-6 * 0.2 * 1e-3) << collision;  // of what the force adds in a step
  }
}

}  // namespace
}  // namespace vug
