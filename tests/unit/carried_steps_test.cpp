// Fixed steps of heat and solutes are held against the speed that the fluid turns out to have.
#include "coupling/carried_steps.hpp"

#include "support/run_vug.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A body force accelerates fluid without walls by 1e-4 in every lattice step.
const std::string falling = R"(
[lattice]
size = [12, 8]
spacing = 1
time_step = 1
[time]
steps = 1000
[flow]
viscosity = 0.1
density = 1
initial_pressure = 0
body_force = [1e-4, 0]
[heat]
fluid_diffusivity = 0.01
solid_diffusivity = 0.01
[[solute.species]]
name = "A"
diffusivity = 0.01
[accuracy]
heat_interval = 16
solute_interval = 4
[output]
history_interval = 100
[boundary.left]
flow = { type = "periodic" }
heat = { type = "periodic" }
solute = { type = "periodic" }
[boundary.right]
flow = { type = "periodic" }
heat = { type = "periodic" }
solute = { type = "periodic" }
[boundary.top]
flow = { type = "periodic" }
heat = { type = "periodic" }
solute = { type = "periodic" }
[boundary.bottom]
flow = { type = "periodic" }
heat = { type = "periodic" }
solute = { type = "periodic" }
)";

Scene scene(const std::vector<std::string>& set = {}) {
  return parse_scene(falling, "a.toml", set);
}

std::vector<HistoryValue> row(double speed) {
  return {{"time_s", 1}, {"largest_mach_1", speed * std::sqrt(3.0)}};
}

TEST(CarriedSteps, MayBeAsLongAsTheirWayAllows) {
  const CarriedStep heat{"heat_interval", 8, 1};
  EXPECT_DOUBLE_EQ(heat.way(0.03), 0.24);
  EXPECT_EQ(heat.longest_at(0), 8);
  EXPECT_EQ(heat.longest_at(0.125), 8);
  EXPECT_EQ(heat.longest_at(0.13), 7);
  EXPECT_EQ(heat.longest_at(0.2), 5);
  EXPECT_EQ((CarriedStep{"solute_interval", 2, 0.4}).longest_at(0.41), 0);
}

TEST(CarriedSteps, AreWarnedOfOnce) {
  CarriedSteps watch(scene(), {});
  const Clock clock{300, 1};
  EXPECT_THAT(watch.look_at_row(clock, {{"time_s", 1}}), IsEmpty()) << "no flow in the row";
  EXPECT_THAT(watch.look_at_row(clock, row(0.03125)), IsEmpty());
  const std::vector<std::string> heat = watch.look_at_row(clock, row(0.035));
  EXPECT_THAT(heat,
              ElementsAre("step 300, 300 s: warning: accuracy.heat_interval is too long for the speed of the "
                          "fluid: 16 lattice steps carry it 0.56 cells, 0.5 at most hold; set it to 14 at most, or "
                          "lower lattice.time_step"));
  EXPECT_THAT(watch.look_at_row(clock, row(0.2)), ElementsAre(HasSubstr("solute_interval is too long")));
  EXPECT_THAT(watch.look_at_row(clock, row(0.3)), IsEmpty());
  EXPECT_THAT(CarriedSteps(scene(), heat).look_at_row(clock, row(0.2)), ElementsAre(HasSubstr("solute_interval")));
  CarriedSteps single(scene({"accuracy.solute_interval=1", "accuracy.heat_interval=1"}), {});
  EXPECT_THAT(single.look_at_row(clock, row(0.45)), ElementsAre(HasSubstr("at most hold; lower lattice.time_step")));
}

TEST(CarriedSteps, AreNoneWhereTheyFollowTheSpeedOrNothingFlows) {
  EXPECT_THAT(carried_steps(scene({"accuracy.tolerance=1e-3"})), IsEmpty());
  Scene still = scene();
  still.flow.reset();
  EXPECT_THAT(carried_steps(still), IsEmpty());
}

/// u = g t: heat's 16 steps are too long from step 312 on, the acid's 4 from step 1000; told of at the rows after that,
/// and not again by a run that is resumed.
TEST(CarriedSteps, AreWatchedInARun) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.toml", out = folder / "out", run = "run " + path + " --threads 1 -o " + out;
  test::write_text(path, falling);
  const test::Outcome first = test::run_vug(run + " --steps 800");
  ASSERT_EQ(first.exit_code, 0) << first.output;
  EXPECT_THAT(first.output, HasSubstr("step 400, 400 s: warning: accuracy.heat_interval is too long"));
  EXPECT_THAT(first.output, Not(HasSubstr("solute_interval is too long")));
  const test::Outcome second = test::run_vug(run + " --resume --steps 1100");
  ASSERT_EQ(second.exit_code, 0) << second.output;
  EXPECT_THAT(second.output, Not(HasSubstr("heat_interval is too long")));
  EXPECT_THAT(second.output, HasSubstr("warning: accuracy.solute_interval is too long"));
}

}  // namespace
}  // namespace vug
