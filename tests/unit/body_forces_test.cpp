// All that acts on the mass of the fluid counts as one body force: the same bounds, and the same flow.
#include "coupling/body_forces.hpp"

#include "coupling/build_modules.hpp"
#include "support/limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::has_limit;
using test::history_value;
using test::limit_of;
using Overrides = std::vector<std::string>;

const std::string of_force = "Mach number that the body force can reach";

/// A channel between plates of 12 cells, in SI with a lattice of 1 mm and 0.1 ms; fluid of 330 K everywhere.
const std::string warm_channel = R"(
[lattice]
size = [0.04, 0.012]
spacing = 1e-3
time_step = 1e-4
[time]
steps = 30000
[flow]
viscosity = 1e-3
density = 1000
initial_pressure = 0
[heat]
fluid_diffusivity = 1e-3
solid_diffusivity = 1e-3
initial_temperature = 330
[[solute.species]]
name = "A"
diffusivity = 1e-3
[boundary.left]
flow = { type = "periodic" }
heat = { type = "periodic" }
solute = { type = "periodic" }
[boundary.right]
flow = { type = "periodic" }
heat = { type = "periodic" }
solute = { type = "periodic" }
)";

/// g beta (T - T_0) = 9.81 x 1e-3 x 30 m/s2, against gravity.
constexpr double push = 9.81 * 1e-3 * 30;
const Overrides by_warmth{"flow.gravity=[-9.81, 0]", "flow.thermal_expansion=1e-3", "flow.reference_temperature=300"};
const Overrides by_force{fmt::format("flow.body_force=[{:.17g}, 0]", push)};

Overrides with(Overrides first, const Overrides& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

BodyForces forces_of(const Overrides& overrides) {
  const Scene scene = parse_scene(warm_channel, "a.toml", overrides);
  return body_forces(scene, units_of(scene));
}

TEST(BodyForces, AreThoseOfEveryTemperatureOfTheCase) {
  const double unit = 1e-3 / (1e-4 * 1e-4);  // m/s2
  const BodyForces both =
      forces_of(with(by_warmth, {"flow.body_force=[1, -2]", "flow.pressure_scale=4",
                                 "boundary.top.heat={ type = \"temperature\", temperature = 290 }"}));
  EXPECT_NEAR(both.at_start[0] * unit * 4, 1 + push, 1e-12);
  EXPECT_NEAR(both.range[0].high * unit * 4, 1 + push, 1e-12);
  EXPECT_NEAR(both.range[0].low * unit * 4, 1 - push / 3, 1e-12);
  EXPECT_NEAR(both.range[1].low * unit * 4, -2, 1e-12);
  EXPECT_NEAR(both.largest(1) * unit * 4, 2, 1e-12);
  EXPECT_EQ(forces_of({}).largest(0), 0);
  EXPECT_EQ(forces_of(with(by_warmth, {"flow.reference_temperature=330"})).largest(0), 0);
}

/// Of one temperature, not that of the reference: the flow is Poiseuille's, and the bound that of the same body force.
TEST(BodyForces, OfWarmFluidDriveItAsABodyForceDoes) {
  const double nu = 1e-3, width = 0.012, sound = 1e-3 / 1e-4 / std::sqrt(3.0);
  const double mach = push * width * width / (8 * nu) / sound;
  Simulation warm(parse_scene(warm_channel, "a.toml", by_warmth));
  Simulation forced(parse_scene(warm_channel, "a.toml", by_force));
  for (const Simulation* run : {&warm, &forced}) {
    EXPECT_NEAR(limit_of(run->limits(), "flow", of_force).value, mach, 1e-9);
    EXPECT_NEAR(limit_of(run->limits(), "solute", "cells per step").value, 0.2, 1e-12) << "the speed limit";
  }
  for (int step = 0; step < 12000; ++step) {
    warm.step();
    forced.step();
  }
  EXPECT_NEAR(history_value(warm, "largest_mach_1"), mach, 0.01 * mach) << "n even: no node is in the middle";
  EXPECT_NEAR(history_value(warm, "largest_mach_1"), history_value(forced, "largest_mach_1"), 1e-9);
}

/// Sides through which everything leaves; the flow at the left one as given, at the right one at the pressure of the
/// start.
Overrides open_sides(const std::string& left) {
  const std::string leaves = ", heat = { type = \"outflow\" }, solute = { type = \"outflow\" } }";
  return {"boundary.left={ flow = " + left + leaves,
          "boundary.right={ flow = { type = \"pressure\", pressure = 0 }" + leaves};
}

const std::string outflow = "{ type = \"outflow\" }", same = "{ type = \"pressure\", pressure = 0 }";

/// Between open sides without pressures of their own, and between pressures that do not hold it.
TEST(BodyForces, OfWarmFluidDriveItBetweenOpenSides) {
  const double sound = 1e-3 / 1e-4 / std::sqrt(3.0);
  const double fall = std::sqrt(2 * push * 0.04), parabola = push * 0.012 * 0.012 / (8 * 1e-3);
  for (const std::string& left : {outflow, same})
    for (const Overrides& force : {by_warmth, by_force}) {
      const LimitTable limits = test::limits_of(warm_channel, with(force, open_sides(left)));
      EXPECT_NEAR(limit_of(limits, "flow", of_force).value, std::min(fall, parabola) / sound, 1e-9) << left;
      EXPECT_NEAR(limit_of(limits, "solute", "cells per step").value, 0.2, 1e-12) << left;
    }
}

/// Where the fluid is at the reference temperature at first, warmth that comes later can drive it as far.
TEST(BodyForces, OfWarmthThatComesLaterBoundTheSpeed) {
  const Overrides later = with(by_warmth, {"flow.reference_temperature=330", "time.steps=1000000",
                                           "boundary.top.heat={ type = \"temperature\", temperature = 360 }"});
  const LimitTable limits = test::limits_of(warm_channel, later);
  const double parabola = push * 0.012 * 0.012 / (8 * 1e-3), convection = std::sqrt(push * 0.04);
  EXPECT_NEAR(limit_of(limits, "flow", of_force).value, parabola / (10 / std::sqrt(3.0)), 1e-9);
  ASSERT_GT(convection, parabola);
  EXPECT_NEAR(limit_of(limits, "solute", "cells per step").value, convection / 10, 1e-9);
  for (const std::string& left : {outflow, same}) {
    const LimitTable open = test::limits_of(warm_channel, with(later, open_sides(left)));
    EXPECT_NEAR(limit_of(open, "flow", of_force).value, parabola / (10 / std::sqrt(3.0)), 1e-9) << left;
  }
}

/// In a closed box no force drives: it is the weight of the fluid.
TEST(BodyForces, DriveNothingInAClosedBox) {
  const Overrides closed{"boundary.left={}", "boundary.right={}"};
  for (const Overrides& force : {by_warmth, by_force}) {
    const LimitTable limits = test::limits_of(warm_channel, with(force, closed));
    EXPECT_FALSE(has_limit(limits, of_force));
    EXPECT_LT(limit_of(limits, "solute", "cells per step").value, 0.1);
  }
}

}  // namespace
}  // namespace vug
