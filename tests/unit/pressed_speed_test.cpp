// The bound of the speed that given pressures drive: which pressures drive what along which way, and that flows keep
// it.
#include "coupling/driving_pressure.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/limit_text.hpp"
#include "support/limits.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vug {
namespace {

using test::largest_mach;
using testing::HasSubstr;

/// A lattice of nx x ny cells, lattice units.
std::string box(int nx, int ny, double viscosity, const std::string& more) {
  return fmt::format(
      "[lattice]\nsize = [{}, {}]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 100000\n[geometry]\n"
      "[flow]\nviscosity = {}\ndensity = 1\ninitial_pressure = 0\n{}",
      nx, ny, viscosity, more);
}
std::string pressed(const std::string& side, const std::string& pressure, const std::string& more = "") {
  return fmt::format("[boundary.{}]\nflow = {{ type = \"pressure\", pressure = {}{} }}\n", side, pressure, more);
}
std::string stretch(const std::string& side, double centre, double width) {
  return fmt::format("side = \"{}\"\ncentre = {}\nwidth = {}\n", side, centre, width);
}

PressedFlow flow_of(const std::string& text) {
  const Scene scene = parse_scene(text, "a.toml");
  const Simulation simulation(scene);
  return find_flow_paths(scene, simulation.parts().geometry, simulation.parts().units).pressed;
}

const Limit& mach_of(const LimitTable& limits) {
  return *std::find_if(limits.begin(), limits.end(),
                       [](const Limit& limit) { return limit.name == "Mach number that the pressures drive"; });
}

/// A channel of 400 x 12 cells that ends in two outlets, of equal pressure where they meet at its upper corner: the
/// bound is p n^2/(8 L) of the way from the inlet to the nearer one, 395 nodes. Beside the outlet in the wall it is
/// wider.
TEST(PressedSpeed, OfOutletsOfEqualPressureIsThatOfTheWayFromTheInlet) {
  const std::string upper = "[boundary.injection]\n" + stretch("top", 397, 6);
  const auto bound = [&](const std::string& right, const std::string& top) {
    return flow_of(box(400, 12, 0.1,
                       pressed("left", "0.01") + pressed("right", right) + upper +
                           fmt::format("flow = {{ type = \"pressure\", pressure = {} }}\n", top)));
  };
  const double way = 12 * 12 / (8 * 395.0);
  EXPECT_NEAR(bound("0", "0").speed, 0.01 * way, 0.01 * 0.01 * way);
  // a unit in the last place drives nothing
  EXPECT_NEAR(bound("0.001", "0.0010000000000000002").speed, 0.009 * way, 0.01 * 0.009 * way);
  // what is left between the outlets flows around their corner, in at most the width of the channel
  const PressedFlow between = bound("0", "0.009");
  EXPECT_GT(between.speed, 0.009 * 12 / 4);
  EXPECT_LT(between.speed, 0.009 * 24 / 4);
  EXPECT_EQ(std::min(between.from, between.to), "boundary.injection");
  EXPECT_EQ(std::max(between.from, between.to), "boundary.right");
}

/// A square with walls at the left and the bottom: an inlet of 8 cells in the left one, and open above and at the
/// right.
std::string square(double top, double viscosity) {
  return box(40, 40, viscosity,
             pressed("right", "0") + pressed("top", fmt::format("{}", top)) + "[boundary.injection]\n" +
                 stretch("left", 20, 8) + "flow = { type = \"pressure\", pressure = 2e-4 }\n");
}

/// The bound is that of the way from the top to the inlet: at most p w/4, with w = 48 at its height, and not that of no
/// way at all between the outlets. Stokes flow from a hole of n cells at the pressure p in the wall of a wide space has
/// the speed p n/(4 nu): half of a hole in a thin screen between -p and p (Hasimoto 1958). So has the run.
TEST(PressedSpeed, OfASquareBetweenTwoOutletsOfEqualPressure) {
  const PressedFlow found = flow_of(square(0, 0.1));
  EXPECT_DOUBLE_EQ(found.speed, 2e-4 * 48 / 4);
  EXPECT_EQ(found.from, "boundary.top");
  EXPECT_EQ(found.to, "boundary.injection");
  Simulation run(parse_scene(square(0, 0.1), "a.toml"));
  const double mach = largest_mach(run, 6000), hasimoto = std::sqrt(3.0) * 2e-4 * 8 / (4 * 0.1);
  EXPECT_NEAR(mach, hasimoto, 0.05 * hasimoto);
  EXPECT_LT(mach, mach_of(run.limits()).value);
}

/// In the corner of two sides of different pressures Stokes flow in a wedge of radius R has the speed p r ln(R/r)/(pi
/// nu), at most 0.117 p R/nu.
TEST(PressedSpeed, OfSidesOfDifferentPressuresThatMeetAtACornerIsThatOfTheWedge) {
  const auto wedge = [](double pressure) {
    return box(30, 30, 0.02, pressed("right", "0") + pressed("top", fmt::format("{}", pressure)));
  };
  const double pressure = 2e-4, stokes = std::sqrt(3.0) * 0.117 * pressure * 30 / 0.02;
  Simulation run(parse_scene(wedge(pressure), "a.toml"));
  const double bound = mach_of(run.limits()).value, mach = largest_mach(run, 6000);
  EXPECT_NEAR(bound, std::sqrt(3.0) * pressure * 60 / (4 * 0.02), 1e-9) << "a layer beside one wall counts twice";
  EXPECT_LT(mach, bound);
  EXPECT_NEAR(mach, stokes, 0.4 * stokes);
  const LimitTable limits = Simulation(parse_scene(wedge(0.02), "a.toml")).limits();
  EXPECT_FALSE(mach_of(limits).inside());
  EXPECT_TRUE(std::isfinite(mach_of(limits).value));
  EXPECT_THAT(warning_of(mach_of(limits)), HasSubstr("from boundary.right to boundary.top: lower lattice.time_step"));
}

FlowBoundary boundary(TimeTable pressure, double ramp_time) {
  FlowBoundary flow;
  flow.kind = FlowBoundaryKind::pressure;
  flow.pressure = std::move(pressure);
  flow.ramp_time = ramp_time;
  return flow;
}

/// At one time: two equal ramps differ nowhere, although each differs from the other at another time.
TEST(DifferenceOverTime, IsThatAtOneTime) {
  const LatticeUnits units = Simulation(parse_scene(box(4, 4, 0.1, ""), "a.toml")).parts().units;
  const auto expect = [&](const FlowBoundary& a, const FlowBoundary& b, double low, double high) {
    const Span span = difference_over_time(a, b, units);
    EXPECT_DOUBLE_EQ(span.low, low);
    EXPECT_DOUBLE_EQ(span.high, high);
  };
  expect(boundary(8, 10), boundary(8, 10), 0, 0);
  expect(boundary(8, 10), boundary(8, 0), -8, 0);
  expect(boundary(8, 10), boundary(8, 40), 0, 6);
  expect(boundary(8, 10), boundary({{0, 10}, {0, 8}}, 0), 0, 0);
  // t/T (1 - 2 t/T) on the way from 1 to -1 is 1/8 at T/4, and 0 in the middle
  expect(boundary({{0, 10}, {8, -8}}, 10), boundary(0.0, 0), -8, 1);
  FlowBoundary outflow;
  outflow.kind = FlowBoundaryKind::outflow;
  expect(boundary(8, 0), outflow, 8, 8);
}

}  // namespace
}  // namespace vug
