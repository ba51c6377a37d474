// Fluid that starts from one pressure under its weight, against d'Alembert's solution of the wave equation.
#include "coupling/weight_wave.hpp"

#include "support/limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

using test::has_limit;
using test::history_value;
using test::limit_of;

const std::string of_weight = "Mach number while the weight sets in";
constexpr double g = 2e-5, sound = 0.57735026918962576;
constexpr int height = 120;

/// A column without walls beside it, lattice units, along an axis; `sides` are its lower and upper end.
std::string column(int axis, const std::string& low, const std::string& high) {
  const auto side = [](const char* name, const std::string& flow) {
    return fmt::format("[boundary.{}]\nflow = {{ {} }}\n", name, flow);
  };
  const std::string joined = "type = \"periodic\"";
  const bool lies = axis == 0;
  return fmt::format(
             "[lattice]\nsize = [{}]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 100000\n"
             "[flow]\nviscosity = 0.01\ndensity = 1\ninitial_pressure = 0\nbody_force = [{}]\n",
             lies ? fmt::format("{}, 4", height) : fmt::format("4, {}", height),
             lies ? fmt::format("-{}, 0", g) : fmt::format("0, -{}", g)) +
         side("left", lies ? low : joined) + side("right", lies ? high : joined) + side("bottom", lies ? joined : low) +
         side("top", lies ? joined : high);
}

const std::string wall = "type = \"wall\"", open = "type = \"pressure\", pressure = 0";
/// That of the column at rest.
const std::string carries = fmt::format("type = \"pressure\", pressure = {:.17g}", g* height);

double mach_of(const Simulation& run) {
  return history_value(run, "largest_mach_1");
}

/// The largest Mach number in the time that sound takes over the column twice.
double largest_mach(const std::string& text) {
  Simulation run(parse_scene(text, "a.toml"));
  return test::largest_mach(run, static_cast<int>(std::ceil(2 * height / sound)), 1);
}

TEST(WeightWave, IsHalfAsFastBetweenTwoWallsAsAtAnOpenEnd) {
  EXPECT_NEAR(weight_wave(g, height, false), g * height / (2 * sound), 1e-15);
  EXPECT_NEAR(weight_wave(g, height, true), g * height / sound, 1e-15);
}

/// What the fluid carries meanwhile is carried at that speed.
TEST(WeightWave, CountsForWhatTheFluidCarries) {
  const std::string text = column(1, wall, wall) + "[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\n";
  EXPECT_NEAR(limit_of(test::limits_of(text), "solute", "cells per step").value, g * height / (2 * sound), 1e-12);
}

/// The front of the sound is as wide as viscosity makes it: some 2 % of the largest speed.
TEST(WeightWave, OfAClosedColumnIsThatOfTheWaveEquation) {
  for (const int axis : {0, 1}) {
    const std::string text = column(axis, wall, wall);
    const double peak = g * height / (2 * sound) / sound;
    EXPECT_NEAR(limit_of(test::limits_of(text), "flow", of_weight).value, peak, 1e-12);
    const double found = largest_mach(text);
    EXPECT_LE(found, 1.001 * peak) << axis;
    EXPECT_GT(found, 0.95 * peak) << axis;
  }
}

/// Until sound arrives from the walls the middle falls freely, u = g t; after H/c_s it is at rest, and falls upwards.
TEST(WeightWave, FallsFreelyUntilSoundArrives) {
  Simulation run(parse_scene(column(1, wall, wall), "a.toml"));
  const double quarter = height / (4 * sound);
  int step = 0;
  for (; step < quarter; ++step) run.step();
  EXPECT_NEAR(mach_of(run), g * step / sound, 0.02 * g * step / sound);
  for (; step < 4 * quarter; ++step) run.step();
  EXPECT_LT(mach_of(run), 0.1 * g * height / (2 * sound) / sound);
}

/// Of a column between a wall and an open end, and between two pressures that will carry it: the front of those rings
/// on the lattice, by 11 %.
TEST(WeightWave, AtAnOpenEndIsThatOfTheWaveEquation) {
  const double peak = g * height / sound / sound;
  for (const int axis : {0, 1})
    for (const auto& [low, high] : {std::pair{wall, open}, {open, wall}, {carries, open}}) {
      const std::string text = column(axis, low, high);
      EXPECT_NEAR(limit_of(test::limits_of(text), "flow", of_weight).value, peak, 1e-12) << low << high;
      const double found = largest_mach(text);
      EXPECT_LE(found, (low == carries ? 1.15 : 1.01) * peak) << axis << low << high;
      EXPECT_GT(found, 0.95 * peak) << axis << low << high;
    }
}

/// Where the fluid has a way, the weight drives it instead.
TEST(WeightWave, IsNoneWhereNothingCarriesTheWeight) {
  const std::string joined = "type = \"periodic\"", slowly = carries + ", ramp_time = 1000";
  for (const auto& [low, high] : {std::pair{joined, joined}, {open, open}, {slowly, open}})
    EXPECT_FALSE(has_limit(test::limits_of(column(1, low, high)), of_weight)) << low;
}

/// Plates four cells apart hold the fluid back before sound has gone far: g w^2/(8 nu).
TEST(WeightWave, IsHeldBackByWalls) {
  std::string text = column(1, wall, wall);
  const std::string joined = "flow = { type = \"periodic\" }";
  for (auto at = text.find(joined); at != std::string::npos; at = text.find(joined))
    text.replace(at, joined.size(), "");
  const std::vector<std::string> thick{"flow.viscosity=0.2"};
  const double parabola = g * 4 * 4 / (8 * 0.2);
  ASSERT_LT(parabola, g * height / (2 * sound));
  EXPECT_NEAR(limit_of(test::limits_of(text, thick), "flow", of_weight).value, parabola / sound, 1e-12);
  Simulation run(parse_scene(text, "a.toml", thick));
  for (int step = 0; step < 300; ++step) {
    run.step();
    ASSERT_LE(mach_of(run), 1.01 * parabola / sound) << step;
  }
}

/// Rock across the column leaves two pieces, of which the higher one counts.
TEST(WeightWave, IsThatOfTheHighestPiece) {
  const std::string rock =
      "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [0, 70]\nto = [4, 75]\n";
  const double peak = g * 70 / (2 * sound) / sound;
  EXPECT_NEAR(limit_of(test::limits_of(column(1, wall, wall) + rock), "flow", of_weight).value, peak, 1e-12);
  // joined ends: the pieces above and below the rock are one, of 115 cells
  const std::string joined = "type = \"periodic\"";
  EXPECT_NEAR(limit_of(test::limits_of(column(1, joined, joined) + rock), "flow", of_weight).value,
              g * 115 / (2 * sound) / sound, 1e-12);
}

/// A fifth of the speed of sound squared as g H is too much, also that of fluid warmer than its reference.
TEST(WeightWave, IsWarnedOfWhereItIsFast) {
  const auto inside = [](double force) {
    return limit_of(test::limits_of(column(1, wall, wall), {fmt::format("flow.body_force=[0, {}]", force)}), "flow",
                    of_weight)
        .inside();
  };
  EXPECT_TRUE(inside(0.34 * 2 * sound * sound / height));
  EXPECT_FALSE(inside(0.36 * 2 * sound * sound / height));
  const std::string heat = "[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.1\ninitial_temperature = 320\n";
  std::string text = column(1, wall, wall);
  for (const char* side : {"left", "right"})
    text.insert(text.find(std::string("[boundary.") + side + "]\n") + std::string(side).size() + 12,
                "heat = { type = \"periodic\" }\n");
  const std::vector<std::string> warm{"flow.body_force=[0, 0]", "flow.gravity=[0, -1e-3]",
                                      "flow.thermal_expansion=1e-3", "flow.reference_temperature=300"};
  EXPECT_NEAR(limit_of(test::limits_of(text + heat, warm), "flow", of_weight).value,
              height * 2e-5 / (2 * sound * sound), 1e-9);
}

}  // namespace
}  // namespace vug
