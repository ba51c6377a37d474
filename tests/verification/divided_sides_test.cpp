// Sides that injections divide: what is the same on both sides of a join must not show it, a profile goes on beyond an
// injection, and a flow rate enters once.
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"
#include "verification/surface_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

using namespace test::surfaces;

struct Direction {
  bool upright;  ///< the flow is along y
  std::string from, to, lower, upper;
};
const std::vector<Direction> directions{{false, "left", "right", "bottom", "top"},
                                        {true, "bottom", "top", "left", "right"},
                                        {false, "right", "left", "bottom", "top"}};

std::string lattice_along(const Direction& way, int along, int across) {
  return lattice(way.upright ? across : along, way.upright ? along : across);
}

std::string side(const std::string& name, const std::string& condition) {
  return "[boundary." + name + "]\nflow = { " + condition + " }\n";
}

/// Cells [first, last) of a side.
std::string injection(const std::string& on, int first, int last, const std::string& condition) {
  return fmt::format(
      "[[boundary.injection]]\nname = \"part\"\nside = \"{}\"\ncentre = {:.17g}\nwidth = {:.17g}\n"
      "flow = {{ {} }}\n",
      on, (first + last) / 2.0 * dx, (last - first) * dx, condition);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t n = 0; n < a.size(); ++n) most = std::max(most, std::abs(a[n] - b[n]));
  return most;
}
double largest(const std::vector<double>& a) {
  return largest_difference(a, std::vector<double>(a.size(), 0));
}

/// A channel between two pressures, or behind a velocity, is the same channel where a part of its inlet or outlet is an
/// injection with the same condition; before, the links across a join were walls (18 % less flow). Parts of an outflow
/// let sound out each by itself: they are one side once the flow has settled.
TEST(DividedSides, OfOneConditionAreOneSide) {
  constexpr int along = 24, across = 12, steps = 8000;
  const std::string high = "type = \"pressure\", pressure = 300004", low = "type = \"pressure\", pressure = 300000";
  const std::string out = "type = \"outflow\"";
  for (const Direction& way : directions)
    for (const std::string& outlet : {low, out}) {
      const std::string scene = lattice_along(way, along, across) + flow + told;
      const std::string ends = side(way.from, high) + side(way.to, outlet);
      test::CoupledRun whole(scene + ends);
      whole.steps(steps);
      const std::vector<double> u = whole.nodes("velocity"), p = whole.nodes("gauge_pressure");
      const double rate = whole.now(way.to + "_mass_flow_kg_per_m_s");
      EXPECT_GT(std::abs(rate), 0);
      for (const auto& [first, last] : {std::pair{4, 7}, std::pair{0, 5}, std::pair{11, 12}})
        for (const bool at_inlet : {true, false}) {
          const std::string name = at_inlet ? way.from : way.to;
          test::CoupledRun divided(scene + ends + injection(name, first, last, at_inlet ? high : outlet));
          divided.steps(steps);
          EXPECT_LT(largest_difference(divided.nodes("velocity"), u), 1e-6 * largest(u)) << name << first << outlet;
          EXPECT_LT(largest_difference(divided.nodes("gauge_pressure"), p), 1e-6 * largest(p)) << name << first;
          const double both =
              divided.now(name + "_mass_flow_kg_per_m_s") + divided.now("injection_part_mass_flow_kg_per_m_s");
          EXPECT_NEAR(both / (at_inlet ? -rate : rate), 1, 1e-6) << name << first << outlet;
        }
    }
}

/// The same across a joined side, where both parts of a divided side meet.
TEST(DividedSides, MeetAcrossAJoinedSide) {
  const std::string low = "type = \"pressure\", pressure = 300000";
  const std::string scene = lattice(16, 10) + flow + told + "[geometry]\ntype = \"shapes\"\n" +
                            test::disc(7 * dx, 3 * dx, 2.2 * dx) +
                            side("left", "type = \"pressure\", pressure = 300004") + side("right", low) +
                            side("bottom", "type = \"periodic\"") + side("top", "type = \"periodic\"");
  test::CoupledRun whole(scene), divided(scene + injection("right", 3, 6, low));
  for (test::CoupledRun* run : {&whole, &divided}) run->steps(12000);
  const std::vector<double> u = whole.nodes("velocity");
  EXPECT_LT(largest_difference(divided.nodes("velocity"), u), 1e-6 * largest(u));
}

/// A uniform flow leaves through a side whose parts prescribe its velocity, its pressure or nothing.
TEST(DividedSides, LetAUniformFlowOut) {
  const double speed = 0.01 * dx / dt;
  for (const Direction& way : directions) {
    const double signed_speed = way.from == "right" ? -speed : speed;
    const std::string velocity =
        way.upright ? fmt::format("[0, {:.17g}]", speed) : fmt::format("[{:.17g}, 0]", signed_speed);
    const std::string given = "type = \"velocity\", velocity = " + velocity;
    for (const std::string open : {"type = \"pressure\", pressure = 3e5", "type = \"outflow\""}) {
      test::CoupledRun run(lattice_along(way, 16, 12) + flow + told + side(way.from, given) + side(way.to, open) +
                           injection(way.to, 4, 7, given) + side(way.lower, "type = \"periodic\"") +
                           side(way.upper, "type = \"periodic\""));
      run.steps(14000);
      const std::vector<double> u = run.nodes("velocity");
      for (std::size_t n = 0; n < u.size() / 2; ++n) {
        EXPECT_NEAR(u[2 * n + way.upright] / signed_speed, 1, 1e-6) << way.to << n << open;
        EXPECT_NEAR(u[2 * n + !way.upright] / speed, 0, 1e-6) << way.to << n << open;
      }
    }
  }
}

/// A rate is that of all parts of its side; before, each part let in all of it.
TEST(DividedSides, LetInAFlowRateOnce) {
  const std::string outlet = side("right", "type = \"pressure\", pressure = 3e5");
  for (const std::string given :
       {"flow_rate = 3e-4", "mass_flow_rate = 0.24", "flow_rate = 3e-4, profile = \"parabolic\"",
        "flow_rate = 3e-4, profile = \"table\", profile_table = [[0, 1], [0.024, 3]]"}) {
    test::CoupledRun run(lattice(16, 12) + flow + told + side("left", "type = \"velocity\", " + given) + outlet +
                         injection("left", 4, 7, "type = \"wall\""));
    run.steps(10);
    EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s"), density * 3e-4, 1e-12) << given;
  }
  test::CoupledRun closed(lattice(16, 12) + flow + told + side("left", "type = \"velocity\", flow_rate = 3e-4") +
                          side("right", "type = \"velocity\", flow_rate = -3e-4") +
                          injection("left", 4, 7, "type = \"wall\""));
  closed.steps(200);
  EXPECT_NEAR(closed.gain("fluid_mass", "boundaries"), 0, 1e-12);
}

/// A profile spans its side. Of 12 cells an injection takes the middle four, and what is left is the integral of the
/// profile over the rest (Simpson's rule, exact for both).
TEST(DividedSides, KeepTheirProfile) {
  const double speed = 0.01 * dx / dt, length = 12 * dx;
  const auto parabola = [](double x) { return 3 * x * x - 2 * x * x * x; };  // integral of 6 x (1 - x)
  const auto slope = [](double x) { return x * x; };                         // of 2 x
  const auto outside = [](const auto& integral) { return integral(4 / 12.0) + integral(1) - integral(8 / 12.0); };
  for (const auto& [profile, share] :
       {std::pair{std::string("profile = \"parabolic\""), outside(parabola)},
        std::pair{std::string("profile = \"table\", profile_table = [[0, 0], [0.024, 2]]"), outside(slope)}}) {
    test::CoupledRun run(lattice(16, 12) + flow + told +
                         side("left", fmt::format("type = \"velocity\", velocity = [{:.17g}, 0], ", speed) + profile) +
                         side("right", "type = \"pressure\", pressure = 3e5") +
                         injection("left", 4, 8, "type = \"wall\""));
    run.steps(10);
    EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s") / (density * speed * length), share, 1e-12) << profile;
  }
}

}  // namespace
}  // namespace vug
