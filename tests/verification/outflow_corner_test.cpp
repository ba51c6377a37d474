// Outflows that meet at a corner of the lattice, and one that a flow reaches as less than a number can square.
#include "support/coupled_run.hpp"
#include "verification/surface_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using namespace test::surfaces;

constexpr int nx = 16, ny = 12;
constexpr double speed = dx / dt;

/// Fluid enters with the velocity (u, v) through two sides and leaves through the other two.
std::string crossing(double u, double v, const std::string& more = "") {
  const bool right = u > 0, up = v > 0;
  const auto given = fmt::format("flow = {{ type = \"velocity\", velocity = [{:.17g}, {:.17g}] }}\n", u, v);
  std::string text = lattice(nx, ny) + flow + told + more;
  for (const char* side : {right ? "left" : "right", up ? "bottom" : "top"})
    text += fmt::format("[boundary.{}]\n", side) + given;
  for (const char* side : {right ? "right" : "left", up ? "top" : "bottom"})
    text += fmt::format("[boundary.{}]\nflow = {{ type = \"outflow\" }}\n", side);
  return text;
}

/// A uniform flow at an angle solves the equations; each side has its share of it. (With a wall in the link through
/// the corner the velocity would be off by more than a third there.)
TEST(OutflowCorner, LetsAUniformFlowOutAtAnyAngle) {
  for (const double u : {0.03 * speed, -0.03 * speed})
    for (const double v : {0.02 * speed, -0.02 * speed}) {
      test::CoupledRun run(crossing(u, v));
      run.steps(8000);
      const std::vector<double> all = run.nodes("velocity");
      for (std::size_t k = 0; k < all.size(); k += 2) {
        EXPECT_NEAR(all[k], u, 1e-6 * speed) << u << " " << v << " node " << k / 2;
        EXPECT_NEAR(all[k + 1], v, 1e-6 * speed) << u << " " << v << " node " << k / 2;
      }
      // the link of the corner is of the left or right side, and carries a sixth of a cell of both velocities
      const double across = density * dx * std::abs(u), up = density * dx * std::abs(v);
      const auto rate = [&](const char* side) { return run.now(std::string(side) + "_mass_flow_kg_per_m_s"); };
      const double ahead = -rate(u > 0 ? "right" : "left"), above = -rate(v > 0 ? "top" : "bottom");
      EXPECT_NEAR(ahead + above, rate(u > 0 ? "left" : "right") + rate(v > 0 ? "bottom" : "top"), 1e-5 * across * ny);
      EXPECT_NEAR(ahead, across * ny, (across + up) / 6);
      EXPECT_NEAR(above, up * nx, (across + up) / 6);
    }
}

/// The wake of an obstacle ends in the corner without noise: the speed stays below that of potential flow around a
/// disc, twice that far away. (With a pressure in the corner it would not.)
TEST(OutflowCorner, IsStableInAWake) {
  constexpr double u = 0.08 * speed, v = 0.03 * speed;
  const std::string wake =
      lattice(120, 80) + "[flow]\ndensity = 800\nviscosity = 4e-5\n" +
      fmt::format(
          "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"disc\"\ncentre = [{}, {}]\nradius = {}\n",
          60 * dx, 62 * dx, 8 * dx);
  std::string sides = crossing(u, v);
  sides = sides.substr(sides.find("[boundary"));
  test::CoupledRun run(wake + sides);
  run.steps(8000);
  const std::vector<double> all = run.nodes("velocity");
  double fastest = 0;
  for (std::size_t k = 0; k < all.size(); k += 2) fastest = std::max(fastest, std::hypot(all[k], all[k + 1]));
  EXPECT_LT(fastest, 2 * std::hypot(u, v));
}

/// What runs ahead of sound, one cell per step, arrives after 1000 cells with speeds whose squares are zero.
TEST(OutflowBeginning, LivesWithSpeedsWhoseSquaresVanish) {
  test::CoupledRun run(
      "[lattice]\nsize = [1000, 6]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 2000\n[flow]\nviscosity = 0.08\n"
      "density = 1\ninitial_pressure = 0\n[geometry]\ntype = \"open\"\n[boundary.left]\nflow = { type = \"velocity\", "
      "velocity = [0.02, 0], profile = \"parabolic\", ramp_time = 2000 }\n[boundary.right]\nflow = { type = "
      "\"outflow\" }\n");
  run.steps(1100);
  EXPECT_GT(run.now("largest_mach_1"), 0.01);
}

}  // namespace
}  // namespace vug
