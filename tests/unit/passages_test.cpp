// The largest speed in passages, against flows whose largest speed is known.
#include "coupling/passages.hpp"

#include "support/limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::history_value;

/// A channel of 14 cells in height, lattice units, through which a velocity drives fluid past shapes.
std::string channel(double velocity, double viscosity, int length, const std::string& shapes, bool walls = true) {
  const std::string free =
      "[boundary.top]\nflow = { type = \"periodic\" }\n[boundary.bottom]\n"
      "flow = { type = \"periodic\" }\n";
  return fmt::format(
             "[lattice]\nsize = [{}, 14]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 100000\n"
             "[flow]\nviscosity = {}\ndensity = 1\ninitial_pressure = 0\n[geometry]\n{}"
             "[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\n"
             "[boundary.left]\nflow = {{ type = \"velocity\", velocity = [{}, 0], ramp_time = 500 }}\n"
             "[boundary.right]\nflow = {{ type = \"pressure\", pressure = 0 }}\n",
             length, viscosity, shapes.empty() ? "type = \"open\"\n" : "type = \"shapes\"\n" + shapes, velocity) +
         (walls ? "" : free);
}

std::string rectangle(int x0, int y0, int x1, int y1) {
  return fmt::format("[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [{}, {}]\nto = [{}, {}]\n", x0, y0, x1, y1);
}

double peak_of(const Simulation& run) {
  return run.parts().paths.passage_peak;
}

/// The largest speed after so many steps.
double speed_after(Simulation& run, int steps) {
  for (int step = 0; step < steps; ++step) run.step();
  return history_value(run, "largest_mach_1") / std::sqrt(3.0);
}

TEST(Passages, ShareAVolumeAsSlitsDo) {
  EXPECT_EQ(peak_of_passages({}), 0);
  EXPECT_DOUBLE_EQ(peak_of_passages({10}), 2.0 / 10);
  EXPECT_DOUBLE_EQ(peak_of_passages({5, 5, 5}), 2.0 / 15);
  for (const std::vector<int>& slits : {std::vector{3, 9}, {9, 3}})
    EXPECT_DOUBLE_EQ(peak_of_passages(slits), 2 * 81 / (27 + 729.0));
}

/// Behind an inflow of one speed everywhere, the parabola is half as fast again in the middle.
TEST(Passages, OfAChannelBoundItsParabola) {
  Simulation run(parse_scene(channel(0.02, 0.1, 60, ""), "a.toml"));
  EXPECT_DOUBLE_EQ(peak_of(run), 2 * 0.02);
  EXPECT_DOUBLE_EQ(run.parts().paths.passage_speed, 0.02);
  EXPECT_NEAR(test::limit_of(run.limits(), "solute", "cells per step").value, 2 * 0.02, 1e-12);
  const double found = speed_after(run, 8000);
  EXPECT_NEAR(found, 1.5 * 0.02, 0.01 * 1.5 * 0.02);
  EXPECT_LT(found, peak_of(run));
  const Simulation slides(parse_scene(channel(0.02, 0.1, 60, "", false), "a.toml"));
  EXPECT_DOUBLE_EQ(peak_of(slides), 0.02) << "no wall slows any of it down";
}

/// Two long slits of 3 and 9 cells: 729 of 756 parts of the volume pass the wider one.
TEST(Passages, OfTwoSlitsBoundTheFasterOne) {
  const double velocity = 0.004;
  Simulation run(parse_scene(channel(velocity, 0.2, 160, rectangle(20, 3, 140, 5)), "a.toml"));
  const double volume = 14 * velocity, parabola = 1.5 * volume * 81 / (27 + 729.0);
  EXPECT_NEAR(peak_of(run), parabola * 2 / 1.5, 1e-12);
  EXPECT_GT(parabola, 1.9 * run.parts().paths.passage_speed) << "far above the mean of the narrowest front";
  const double found = speed_after(run, 20000);
  EXPECT_NEAR(found, parabola, 0.03 * parabola);
}

/// A slit of 4 cells between a dead end that is open to the inflow and one that is open to the outlet, all along it:
/// the whole volume passes the slit.
TEST(Passages, OfADeadEndCountNothing) {
  const double velocity = 0.004;
  const std::string walls = rectangle(0, 4, 158, 5) + rectangle(2, 9, 160, 10);
  const std::string ends = rectangle(0, 0, 1, 4) + rectangle(159, 10, 160, 14);  // nothing enters or leaves there
  Simulation run(parse_scene(channel(velocity, 0.02, 160, walls + ends), "a.toml"));
  const double volume = 9 * velocity, parabola = 1.5 * volume / 4;
  EXPECT_DOUBLE_EQ(run.parts().paths.passage_speed, volume / 4);
  EXPECT_NEAR(peak_of(run), parabola * 2 / 1.5, 1e-12);
  // of four nodes the faster ones
  EXPECT_NEAR(speed_after(run, 60000), 15.0 / 16 * parabola, 0.02 * parabola);
}

/// A jet behind a sharp edge is narrower than the opening: up to (pi + 2)/pi times as fast as the mean in it.
TEST(Passages, OfASharpEdgeBoundItsJet) {
  Simulation run(parse_scene(channel(0.01, 0.006, 120, rectangle(40, 0, 42, 8)), "a.toml"));
  const double mean = 0.01 * 14 / 6;
  EXPECT_DOUBLE_EQ(peak_of(run), 2 * mean);
  const double found = speed_after(run, 12000);
  EXPECT_GT(found, 1.3 * mean);
  EXPECT_LT(found, peak_of(run));
}

}  // namespace
}  // namespace vug
