// Stress on the sides of the rock, supports and the rock beyond, in SI: a case's rock against Hooke's law.
#include "dem_support.hpp"
#include "support/coupled_run.hpp"
#include "support/mean_strain.hpp"
#include "support/rock_output.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

constexpr double width = 0.020, height = 0.014;
// measured on larger assemblies with these bonds (docs/validation.md); this small one differs by up to 2 %
constexpr double young = 27.8e9, poisson = 0.237;

const std::string block = R"(
[lattice]
size = [0.020, 0.014]
spacing = 1e-3
time_step = 1e-6
[time]
steps = 100000
[geometry]
type = "rock"
[rock]
element_size = 2.5e-3
[heat]
fluid_diffusivity = 0.8
solid_diffusivity = 0.8
initial_temperature = 320
[mechanics]
thermal_expansion = 1e-5
local_damping = 0.7
[mechanics.bond]
normal_strength = 1e12
cohesion = 1e12
)";

std::string side(const std::string& name, const std::string& traction, double kelvin = 320) {
  return "[boundary." + name + "]\ntraction = { " + traction +
         " }\nheat = { type = \"temperature\", temperature = " + std::to_string(kelvin) + " }\n";
}

/// Mean displacement of the triangles whose centroid is near the right or upper end.
double displacement_of_end(const test::CoupledRun& run, int axis) {
  const auto place = test::host_copy(run.rock().particles().x0);
  const auto u = test::host_copy(run.rock().particles().u);
  double sum = 0, n = 0;
  for (int i = 0; i < run.rock().particles().count; ++i)
    if (place(i, axis) > (axis == 0 ? width : height) - 1.5e-3) sum += u(i, axis), n += 1;
  return sum / n;
}

TEST(RockInSI, IsCompressedByTheStressOnItsSides) {
  const std::vector<std::array<std::string, 4>> stressed_and_held = {{"right", "left", "top", "bottom"},
                                                                     {"left", "right", "bottom", "top"}};
  for (const auto& [x, held_x, y, held_y] : stressed_and_held) {
    const test::CoupledRun run(block + side(x, "normal_stress = 5e6") + side(held_x, "support = \"roller\"") +
                               side(y, "normal_stress = 7.5e6") + side(held_y, "support = \"roller\""));
    EXPECT_NEAR(test::mean_strain(run.rock(), 0) / (-(5e6 - poisson * 7.5e6) / young), 1, 0.03) << x;
    EXPECT_NEAR(test::mean_strain(run.rock(), 1) / (-(7.5e6 - poisson * 5e6) / young), 1, 0.03) << y;
    // what holds the rock carries the stress on the other side, N/m
    const double push_x = run.rock().reaction(x == "right" ? RockSide::left : RockSide::right).x;
    const double push_y = run.rock().reaction(y == "top" ? RockSide::bottom : RockSide::top).y;
    EXPECT_NEAR(push_x / ((x == "right" ? 1 : -1) * 5e6 * height), 1, 1e-3) << x;
    EXPECT_NEAR(push_y / ((y == "top" ? 1 : -1) * 7.5e6 * width), 1, 1e-3) << y;
  }
}

TEST(RockInSI, TensionOnASideStretchesIt) {
  const test::CoupledRun run(block + side("right", "normal_stress = -2e6") + side("left", "support = \"roller\""));
  EXPECT_NEAR(test::mean_strain(run.rock(), 0) / (2e6 / young), 1, 0.03);
  EXPECT_NEAR(test::mean_strain(run.rock(), 1) / (-poisson * 2e6 / young), 1, 0.03);
}

TEST(RockInSI, GrowsFreelyWhenWarmed) {
  test::CoupledRun run(block + side("left", "support = \"free\"", 370) + side("right", "support = \"free\"", 370) +
                       side("bottom", "support = \"free\"", 370) + side("top", "support = \"free\"", 370));
  run.steps(600);
  for (const int axis : {0, 1}) EXPECT_NEAR(test::mean_strain(run.rock(), axis) / (1e-5 * 50), 1, 1e-3);
  for (const double stress : test::of_bonds(run.rock(), "stress")) EXPECT_NEAR(stress, 0, 1e-3 * 1e-5 * 50 * young);
}

/// A shear stress on a side counts along +x or +y, whichever lies in it; what is held opposite bears it, N/m.
TEST(RockInSI, ShearStressPushesAlongItsSide) {
  const std::vector<std::pair<std::string, std::string>> sheared_and_held = {
      {"right", "left"}, {"left", "right"}, {"top", "bottom"}, {"bottom", "top"}};
  for (const auto& [sheared, held] : sheared_and_held) {
    const test::CoupledRun run(block + side(sheared, "shear_stress = 2e6") + side(held, "support = \"fixed\""));
    const auto reaction = run.rock().reaction(held == "left"    ? RockSide::left
                                              : held == "right" ? RockSide::right
                                              : held == "top"   ? RockSide::top
                                                                : RockSide::bottom);
    const bool upright = held == "left" || held == "right";
    const double load = 2e6 * (upright ? height : width);
    EXPECT_NEAR((upright ? reaction.y : reaction.x) / -load, 1, 1e-3) << sheared;
    EXPECT_NEAR((upright ? reaction.x : reaction.y) / load, 0, 1e-3) << sheared;
  }
}

/// Rock beyond that gives way by 1/S pushes back with S u: u = alpha dT L / (1 + S L / E).
TEST(RockInSI, RockBeyondResistsItsGrowth) {
  const double S = 1e12;  // Pa/m
  for (const int axis : {0, 1}) {
    const std::string spring = axis == 0 ? "right" : "top", open = axis == 0 ? "top" : "right";
    test::CoupledRun run(block + side("left", "support = \"roller\"", 370) + side(spring, "stiffness = 1e12", 370) +
                         side("bottom", "support = \"roller\"", 370) + side(open, "support = \"free\"", 370));
    run.steps(800);
    const double u = displacement_of_end(run, axis);
    const double length = (axis == 0 ? width : height) - 1e-3;  // from centroid to centroid
    EXPECT_NEAR(u / (1e-5 * 50 * length / (1 + S * length / young)), 1, 0.05) << axis;
    const auto held = run.rock().reaction(axis == 0 ? RockSide::left : RockSide::bottom);
    EXPECT_NEAR((axis == 0 ? held.x : held.y) / (S * u * (axis == 0 ? height : width)), 1, 0.03) << axis;
  }
}

/// The stress of the preload is there before the rock beyond begins to answer.
TEST(RockInSI, RockBeyondAnswersToWhatComesAfterThePreload) {
  const std::string rest =
      side("left", "support = \"roller\"") + side("bottom", "support = \"roller\"") + side("top", "support = \"free\"");
  test::CoupledRun dead(block + rest + side("right", "normal_stress = 5e6"));
  test::CoupledRun backed(block + rest + side("right", "normal_stress = 5e6, stiffness = 1e12"));
  dead.steps(100);
  backed.steps(100);
  EXPECT_NEAR(displacement_of_end(backed, 0) / displacement_of_end(dead, 0), 1, 1e-4);
}

/// The rock beyond answers what comes after the preload, whatever output counts from.
TEST(RockInSI, RockBeyondDoesNotDependOnWhatOutputCountsFrom) {
  const auto pressed = [](const std::string& beyond) {
    return block + side("left", "support = \"roller\"", 370) + side("bottom", "support = \"roller\"", 370) +
           side("top", "support = \"free\"", 370) + side("right", "normal_stress = 5e6" + beyond, 370) +
           "[[output.gauges]]\nname = \"end\"\ntype = \"displacement\"\nat = [0.0195, 0.007]\n";
  };
  const std::string backed = pressed(", stiffness = 1e12"), unloaded = "mechanics.displacement_from=unloaded";
  test::CoupledRun after(backed), before(backed, {unloaded}), dead(pressed(""), {unloaded});
  const double preload = before.now("end_x_m");
  EXPECT_NEAR(preload / dead.now("end_x_m"), 1, 1e-9);
  EXPECT_NEAR(preload / (-5e6 / young * width), 1, 0.12);  // between the gauge and centroids at the rollers
  EXPECT_EQ(after.now("end_x_m"), 0);
  after.steps(300);
  before.steps(300);
  EXPECT_EQ(before.now("elastic_energy_J_per_m"), after.now("elastic_energy_J_per_m"));
  EXPECT_NEAR(before.now("end_x_m") - preload, after.now("end_x_m"), 1e-15);
}

}  // namespace
}  // namespace vug
