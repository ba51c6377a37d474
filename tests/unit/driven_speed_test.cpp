// The bounds of the speed that pressures and body forces drive, against the runs themselves.
#include "coupling/driving_pressure.hpp"
#include "support/limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using Overrides = std::vector<std::string>;
using test::largest_mach;

const std::string of_pressures = "Mach number that the pressures drive";
const std::string of_force = "Mach number that the body force can reach";

/// The value of a limit; -1: there is none.
double limit_of(const Simulation& run, const std::string& name) {
  for (const Limit& limit : run.limits())
    if (limit.name == name) return limit.value;
  return -1;
}

TEST(LargestDrive, IsTheDifferenceOfPotentials) {
  EXPECT_EQ(largest_drive({}, {}), 0);
  EXPECT_EQ(largest_drive({{3, 3}}, {}), 3) << "from the pressure at the start";
  EXPECT_EQ(largest_drive({{3, 3}, {-2, 1}}, {}), 5);
  EXPECT_EQ(largest_drive({{3, 3}, {1, 2}}, {}), 3);
  EXPECT_EQ(largest_drive({{3, 3}, {3, 3}}, {0, 4}), 0) << "a column at rest under its weight";
  EXPECT_EQ(largest_drive({{5, 5}, {3, 3}}, {0, 4}), 2);
  EXPECT_EQ(largest_drive({{6, 6}, {5, 5}}, {0, 4}), 2) << "the fluid is at 4 at most at the start";
}

const std::string channel = R"(
[lattice]
size = [40, 30]
spacing = 1
time_step = 1
[time]
steps = 4000
[flow]
viscosity = 0.02
density = 1
initial_pressure = 1
[boundary.left]
flow = { type = "pressure", pressure = 1.0002 }
[boundary.right]
flow = { type = "pressure", pressure = 0.9998 }
)";

/// The pressure at the start may be between the others.
TEST(DrivenSpeed, OfPressuresIsThatOfTheirDifference) {
  Simulation run(parse_scene(channel, "a.toml"));
  const double viscous = 4e-4 * 30 * 30 / (8 * 0.02 * 40);
  EXPECT_NEAR(limit_of(run, "pressure difference"), 4e-4, 1e-12);
  EXPECT_NEAR(limit_of(run, of_pressures), std::sqrt(3.0) * std::max(viscous, std::sqrt(2 * 4e-4)), 1e-9);
  EXPECT_LE(largest_mach(run, 4000), limit_of(run, of_pressures));
}

/// A column of water under its weight, as high as the lattice; upright or lying.
std::string column(int axis, double excess) {
  return fmt::format(R"(
[lattice]
size = [{}]
spacing = 1e-3
time_step = 2e-4
[time]
steps = 4000
[flow]
viscosity = 1e-4
density = 1000
initial_pressure = 1e5
body_force = [{}]
[boundary.{}]
flow = {{ type = "pressure", pressure = {:.17g} }}
[boundary.{}]
flow = {{ type = "pressure", pressure = 1e5 }}
)",
                     axis == 0 ? "0.1, 0.02" : "0.02, 0.1", axis == 0 ? "-9.81, 0" : "0, -9.81",
                     axis == 0 ? "left" : "bottom", 1e5 + 981 + excess, axis == 0 ? "right" : "top");
}

TEST(DrivenSpeed, OfAColumnUnderItsWeightIsNone) {
  for (const int axis : {0, 1}) {
    Simulation run(parse_scene(column(axis, 0), "a.toml"));
    EXPECT_NEAR(limit_of(run, "pressure difference"), 981 / 25e3, 1e-9);
    EXPECT_LT(limit_of(run, of_pressures), 1e-6) << axis;
    EXPECT_LT(limit_of(run, of_force), 1e-6) << axis;
    largest_mach(run, 3500);
    EXPECT_LT(largest_mach(run, 500), 0.01) << axis;
  }
}

/// Of 20 Pa too much at the bottom, and of 981 Pa too much where the weight acts the other way.
TEST(DrivenSpeed, IsThatOfWhatTheWeightLeavesOfThePressures) {
  const double height = 0.1, sound = 5 / std::sqrt(3.0);
  for (const int axis : {0, 1})
    for (const auto& [excess, left] : {std::pair{20.0, 20.0}, {-2 * 981.0, 2 * 981.0}}) {
      Simulation run(parse_scene(column(axis, excess), "a.toml"));
      const double bernoulli = std::sqrt(2 * left / 1000), parabola = left / (1000 * height) * 0.02 * 0.02 / (8 * 1e-4);
      EXPECT_NEAR(limit_of(run, of_pressures), std::max(bernoulli, parabola) / sound, 1e-6) << axis << ' ' << excess;
      EXPECT_NEAR(limit_of(run, of_force), std::min(bernoulli, parabola) / sound, 1e-6) << axis << ' ' << excess;
    }
}

/// Between an outflow, whose pressure follows, and a pressure all of the weight drives; so it does while pressures
/// rise.
TEST(DrivenSpeed, IsThatOfTheWeightWhereNoPressureHoldsIt) {
  const double weight = std::min(std::sqrt(2 * 0.981), 9.81 * 0.02 * 0.02 / (8 * 1e-4)) / (5 / std::sqrt(3.0));
  const auto with = [](const char* bottom) {
    return limit_of(Simulation(parse_scene(column(1, 0), "a.toml", {std::string("boundary.bottom.flow=") + bottom})),
                    of_force);
  };
  EXPECT_NEAR(with("{ type = \"outflow\" }"), weight, 1e-9);
  EXPECT_NEAR(with("{ type = \"pressure\", pressure = 100981, ramp_time = 0.1 }"), weight, 1e-9);
}

/// Hot fluid is thinner than the viscosity of the case says.
const std::string warm = R"(
[lattice]
size = [40, 12]
spacing = 1
time_step = 1
[time]
steps = 30000
[flow]
viscosity = 0.2
density = 1
initial_pressure = 0
body_force = [1e-5, 0]
viscosity_activation_energy = 6e4
reference_temperature = 300
[heat]
fluid_diffusivity = 0.1
solid_diffusivity = 0.1
initial_temperature = 330
[boundary.left]
flow = { type = "periodic" }
heat = { type = "periodic" }
[boundary.right]
flow = { type = "periodic" }
heat = { type = "periodic" }
)";

TEST(DrivenSpeed, OfABodyForceIsThatOfTheThinnestFluid) {
  const double nu = 0.2 * std::exp(6e4 / 8.314462618 * (1 / 330.0 - 1 / 300.0));
  Simulation run(parse_scene(warm, "a.toml"));
  EXPECT_NEAR(limit_of(run, of_force), std::sqrt(3.0) * 1e-5 * 12 * 12 / (8 * nu), 1e-9);
  const double mach = largest_mach(run, 12000);
  EXPECT_LE(mach, 1.001 * limit_of(run, of_force));
  EXPECT_GT(mach, 0.9 * limit_of(run, of_force));
}

TEST(LowestViscosity, MayBeAtAPointOfTheTable) {
  FlowSection flow;
  flow.viscosity = 3;
  EXPECT_EQ(flow.lowest_viscosity(300, 400), 3);
  flow.viscosity_table = {{280, 2}, {320, 0.5}, {350, 1}, {500, 0.1}};
  EXPECT_EQ(flow.lowest_viscosity(300, 400), 0.5);
  EXPECT_EQ(flow.lowest_viscosity(330, 340), flow.viscosity_at(330));
  EXPECT_EQ(flow.lowest_viscosity(360, 370), flow.viscosity_at(370));
}

}  // namespace
}  // namespace vug
