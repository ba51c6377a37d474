// Pressures far from that of the start, in single precision: what is said of them, and what they cost.
#include "coupling/far_pressures.hpp"

#include "coupling/check.hpp"
#include "support/limits.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using Overrides = std::vector<std::string>;

/// A channel of 20 x 11 cells, lattice units, between two pressures 1e-4 apart, this far from that of the start.
std::string channel(double base) {
  return fmt::format(
      "[lattice]\nsize = [20, 11]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 3000\n"
      "[flow]\nviscosity = 0.2\ndensity = 1\ninitial_pressure = 1\n"
      "[boundary.left]\nflow = {{ type = \"pressure\", pressure = {:.17g} }}\n"
      "[boundary.right]\nflow = {{ type = \"pressure\", pressure = {:.17g} }}\n",
      1 + base + 1e-4, 1 + base);
}

const std::string single = "accuracy.precision=\"single\"";

std::string said_of(const std::string& text, Overrides overrides) {
  const Scene scene = parse_scene(text, "a.toml", overrides);
  const Simulation run(scene);
  return warning_of_far_pressures(scene, run.parts().paths, run.parts().units);
}

PressureLevels levels_of(const std::string& text, const Overrides& overrides) {
  const Scene scene = parse_scene(text, "a.toml", overrides);
  const Simulation run(scene);
  return pressure_levels(scene, run.parts().paths, run.parts().units).value();
}

TEST(FarPressures, AreMeasuredByWhatDrives) {
  const PressureLevels two = levels_of(channel(0.02), {});
  EXPECT_NEAR(two.distance, 0.0201, 1e-12);
  EXPECT_NEAR(two.difference, 1e-4, 1e-12);
  EXPECT_NEAR(two.middle, 1.02005, 1e-12);
  const PressureLevels free = levels_of(channel(0.02), {"boundary.right.flow={ type = \"outflow\" }"});
  EXPECT_NEAR(free.difference, 0.0201, 1e-12) << "down to the pressure of the start";
  // 12 nu u L/n^2
  const PressureLevels fed =
      levels_of(channel(0.02), {"boundary.left.flow={ type = \"velocity\", velocity = [1e-3, 0] }"});
  EXPECT_NEAR(fed.difference, 12 * 0.2 * 1e-3 * 20 / (11.0 * 11), 1e-9);
  EXPECT_NEAR(levels_of(channel(0.02), {"flow.body_force=[1e-5, 0]"}).difference, 20e-5, 1e-12);
}

TEST(FarPressures, AreWarnedOfInSinglePrecisionOnly) {
  EXPECT_EQ(said_of(channel(0.02), {}), "");
  EXPECT_EQ(said_of(channel(0.02), {single}),
            "single precision: the given pressures are up to 0.0201 Pa from flow.initial_pressure and drive the flow "
            "by 0.0001 Pa only, so that velocities lose digits; set flow.initial_pressure to about 1.02 Pa, or "
            "accuracy.precision = \"double\"");
  EXPECT_EQ(said_of(channel(0.02), {single, "flow.initial_pressure=1.02"}), "");
  EXPECT_EQ(said_of(channel(0.0015), {single}), "");
  EXPECT_THAT(check_case(parse_scene(channel(0.02), "a.toml", {single})).warnings,
              Contains(HasSubstr("single precision: the given pressures")));
}

/// Largest error of the velocity along the channel, over its largest, against Poiseuille's parabola where the sides are
/// so many times as far from the pressure of the start as they differ, by 1e-5.
double error_at(double times, const std::string& precision) {
  constexpr int nx = 20, ny = 11;
  constexpr double drop = 1e-5, viscosity = 0.2;
  const double low = 1 + times * drop;
  Simulation run(parse_scene(channel(0), "a.toml",
                             {precision, fmt::format("boundary.left.flow.pressure={:.17g}", low + drop),
                              fmt::format("boundary.right.flow.pressure={:.17g}", low)}));
  for (int step = 0; step < 4000; ++step) run.step();
  const FieldList fields = run.fields();
  const auto velocity = std::find_if(fields.lattice.begin(), fields.lattice.end(),
                                     [](const Field& field) { return field.name == "velocity"; });
  std::vector<double> u(2 * nx * ny);
  velocity->read(u);
  double error = 0;
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) {
      const double parabola = drop / (2 * viscosity * nx) * (y + 0.5) * (ny - y - 0.5);
      error = std::max(error, std::abs(u[2 * (y * nx + x)] - parabola));
    }
  return error / (drop / (8 * viscosity * nx) * ny * ny);
}

/// Rounding is a share of the distance, the velocity one of the difference. Measured in single precision: 4e-6 at the
/// pressures of the start and 6e-5 far away, with the same error of the scheme, 6e-7.
TEST(FarPressures, CostDigits) {
  for (const double times : {0.0, 500.0}) EXPECT_LT(error_at(times, "accuracy.precision=\"double\""), 1e-6) << times;
  const double near = error_at(0, single), far = error_at(500, single);
  EXPECT_LT(near, 1e-5);
  EXPECT_GT(far, 5 * near);
  EXPECT_LT(far, 5e-4);
}

}  // namespace
}  // namespace vug
