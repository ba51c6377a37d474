// Reactions as gauges of a case read them: each side its own, stretches by the middles of edges, and in all what the
// loads are; and loads of a case that find no rock.
#include "base/require.hpp"
#include "support/coupled_run.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vug {
namespace {

constexpr double width = 0.04, height = 0.02;

const std::string block = R"(
[lattice]
size = [0.04, 0.02]
spacing = 2e-3
time_step = 1e-6
[time]
steps = 10
[geometry]
type = "rock"
[rock]
element_size = 2e-3
[mechanics]
young_modulus = "30 GPa"
poisson_ratio = 0.25
[mechanics.bond]
normal_strength = 1e12
cohesion = 1e12
)";

std::string traction(const std::string& side, const std::string& load) {
  return "[boundary." + side + "]\ntraction = { " + load + " }\n";
}

std::string reaction(const std::string& name, const std::string& side, const std::string& stretch = "") {
  return "[[output.gauges]]\nname = \"" + name + "\"\ntype = \"reaction\"\nside = \"" + side + "\"\n" + stretch;
}

std::string all_sides() {
  return reaction("right", "right") + reaction("top", "top") + reaction("left", "left") + reaction("bottom", "bottom");
}

TEST(ReactionGauge, ReadsWhatItsOwnSideHolds) {
  for (const std::string upright : {"left", "right"})
    for (const std::string level : {"bottom", "top"}) {
      const std::string free = upright == "left" ? "right" : "left", loaded = level == "top" ? "bottom" : "top";
      const test::CoupledRun run(block + traction(upright, "support = \"roller\"") +
                                 traction(level, "support = \"roller\"") + traction(free, "normal_stress = 5e6") +
                                 traction(loaded, "normal_stress = 7e6") + all_sides());
      for (const std::string& none :
           {free + "_x", free + "_y", loaded + "_x", loaded + "_y", upright + "_y", level + "_x"})
        EXPECT_EQ(run.now(none + "_N_per_m"), 0) << none;
      const double sense_x = upright == "left" ? 1 : -1, sense_y = level == "bottom" ? 1 : -1;
      EXPECT_NEAR(run.now(upright + "_x_N_per_m"), sense_x * 5e6 * height, 1e-6 * 5e6 * height);
      EXPECT_NEAR(run.now(level + "_y_N_per_m"), sense_y * 7e6 * width, 1e-6 * 7e6 * width);
    }
}

/// A triangle in the corner is held along x and y by both: along x it counts for the upright side, along y for the
/// level one. Not every corner has such a triangle.
TEST(ReactionGauge, OfSidesThatHoldOneTriangleAddUpToTheLoads) {
  for (const std::string upright : {"left", "right"})
    for (const std::string level : {"bottom", "top"}) {
      const std::string free = upright == "left" ? "right" : "left", loaded = level == "top" ? "bottom" : "top";
      const test::CoupledRun run(block + traction(upright, "support = \"fixed\"") +
                                 traction(level, "support = \"fixed\"") +
                                 traction(free, "normal_stress = 5e6, shear_stress = 1e6") +
                                 traction(loaded, "normal_stress = 7e6, shear_stress = -2e6") + all_sides());
      double x = 0, y = 0;
      for (const std::string side : {"right", "top", "left", "bottom"}) {
        x += run.now(side + "_x_N_per_m");
        y += run.now(side + "_y_N_per_m");
      }
      const double push_x = (free == "right" ? -5e6 : 5e6) * height - 2e6 * width;
      const double push_y = 1e6 * height + (loaded == "top" ? -7e6 : 7e6) * width;
      EXPECT_NEAR(x, -push_x, 1e-6 * std::abs(push_x)) << upright << level;
      EXPECT_NEAR(y, -push_y, 1e-6 * std::abs(push_y)) << upright << level;
    }
}

/// As the cantilever of the examples: the free sides hold nothing.
TEST(ReactionGauge, OfFreeSidesBesideAFixedOneIsZero) {
  const test::CoupledRun run(block + traction("left", "support = \"fixed\"") +
                             traction("right", "shear_stress = -1e5") + all_sides());
  for (const char* none : {"right_x", "right_y", "top_x", "top_y", "bottom_x", "bottom_y"})
    EXPECT_EQ(run.now(std::string(none) + "_N_per_m"), 0) << none;
  EXPECT_NEAR(run.now("left_y_N_per_m"), 1e5 * height, 1e-6 * 1e5 * height);
}

TEST(ReactionGauge, OfStretchesAddsUpToTheSide) {
  // at a vertex, within an edge, and at the middle of one
  for (const double limit : {0.02, 0.0203, 0.021, 0.013}) {
    const test::CoupledRun run(block + traction("bottom", "support = \"fixed\"") +
                               traction("top", "normal_stress = 6e6") + reaction("whole", "bottom") +
                               reaction("low", "bottom", fmt::format("last = {}\n", limit)) +
                               reaction("high", "bottom", fmt::format("first = {}\n", limit)));
    const double sum = run.now("low_y_N_per_m") + run.now("high_y_N_per_m");
    EXPECT_NEAR(sum, 6e6 * width, 1e-6 * 6e6 * width) << limit;
    EXPECT_NEAR(run.now("whole_y_N_per_m"), sum, 1e-9 * sum) << limit;
    EXPECT_NEAR(run.now("low_y_N_per_m"), 6e6 * limit, 0.15 * 6e6 * limit) << limit;
  }
}

TEST(LoadsOfACase, ThatFindNoRockAreRefused) {
  const auto said = [](const std::string& loads) -> std::string {
    try {
      const test::CoupledRun run(block + loads);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string part = "[[boundary.top.traction.parts]]\nfrom = 0.0199\nto = 0.0201\n";
  EXPECT_EQ(said(part + "normal_stress = 1e6\n"), "") << "a stress acts on the length given";
  EXPECT_THAT(said(part + "support = \"fixed\"\nvelocity = [0.0, -1.0]\n"),
              testing::StartsWith("case.toml: boundary.top.traction.parts.0: the rock has no edge between its ends to "
                                  "hold; "));
}

}  // namespace
}  // namespace vug
