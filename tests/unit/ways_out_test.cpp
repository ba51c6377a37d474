// What is pressed into a space and finds no way out, also at some times only or by a surface that moves; and how fast a
// body force may drive the fluid where it has a way.
#include "base/require.hpp"
#include "coupling/events.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// A channel of 40 x 12 cells, lattice units, with shapes and sides.
std::string channel(const std::string& shapes, const std::string& sides) {
  return "[lattice]\nsize = [40, 12]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 1000000\n"
         "[flow]\nviscosity = 0.1\ndensity = 1\ninitial_pressure = 0\n[geometry]\n" +
         (shapes.empty() ? std::string() : "type = \"shapes\"\n" + shapes) + sides;
}
std::string rectangle(const char* from, const char* to) {
  return std::string("[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = ") + from + "\nto = " + to + "\n";
}
const std::string belt = "[[geometry.shapes]]\ntype = \"disc\"\nname = \"belt\"\ncentre = [10, 6]\nradius = 3\n";
std::string moving(const std::string& velocity) {
  return "[boundary.shape.belt]\nflow = { type = \"wall\", velocity = " + velocity + " }\n";
}
std::string side(const std::string& name, const std::string& flow) {
  return "[boundary." + name + "]\nflow = { " + flow + " }\n";
}
const std::string joined = side("left", "type = \"periodic\"") + side("right", "type = \"periodic\"");

FlowPaths paths(const std::string& text, const std::vector<std::string>& keys = {}) {
  const Scene scene = parse_scene(text, "a.toml", keys);
  const Simulation simulation(scene);
  return find_flow_paths(scene, simulation.parts().geometry, simulation.parts().units);
}
std::string refusal(const std::string& text) {
  try {
    const Simulation simulation(parse_scene(text, "a.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// All in fluid, it takes in behind what it pushes out in front; half in rock, it is a pump in one direction only.
TEST(WaysOut, AMovingSurfacePartlyInRockIsAPump) {
  const std::string rock = rectangle("[0, 0]", "[10, 12]");
  EXPECT_EQ(refusal(channel(belt, moving("[0.01, 0.02]"))), "");
  EXPECT_THAT(paths(channel(belt, moving("[0.01, 0.02]"))).warnings, IsEmpty());
  EXPECT_EQ(refusal(channel(rock + belt, moving("[0.01, 0]"))),
            "a.toml: boundary.shape.belt.flow presses fluid into a space that has no other opening: its moving surface "
            "is not all in that fluid");
  EXPECT_THAT(refusal(channel(rock + belt, moving("[-0.01, 0]"))), HasSubstr("draws fluid out of a space"));
  EXPECT_EQ(refusal(channel(rock + belt, moving("[0, 0.01]"))), "");
  EXPECT_THAT(refusal(channel(rock + belt, moving("[[0, 0, 0], [10, 0, 0.01], [20, 0.01, 0]]"))),
              HasSubstr("presses fluid into a space"));
  // a piston from wall to wall presses into the space before it
  const std::string piston =
      "[[geometry.shapes]]\ntype = \"rectangle\"\nname = \"belt\"\nfrom = [18, 0]\nto = [22, 12]\n";
  EXPECT_THAT(refusal(channel(piston, moving("[0.01, 0]"))), HasSubstr("fluid"));
  EXPECT_EQ(refusal(channel(piston, joined + moving("[0.01, 0]"))), "");
  // with a way out it is a remark: six rows of cells and two diagonal links of 1/6 each at the face of the rock
  const std::string outlet = side("right", "type = \"outflow\"");
  EXPECT_THAT(
      paths(channel(rock + belt, outlet + moving("[0.01, 0]"))).warnings,
      Contains("boundary.shape.belt.flow.velocity: the moving surface is not all in one fluid, and presses into "
               "it up to 0.0633 m2/s"));
  EXPECT_THAT(paths(channel(belt, outlet + moving("[0.01, 0]"))).warnings, IsEmpty());
}

/// Inflow and outflow of equal peaks at other times.
TEST(WaysOut, VelocitiesMustBalanceAtAllTimes) {
  const auto in_and_out = [](const char* in, const char* out) {
    return channel("", side("left", std::string("type = \"velocity\", velocity = ") + in) +
                           side("right", std::string("type = \"velocity\", velocity = ") + out));
  };
  const auto warnings = [&](const char* in, const char* out) { return paths(in_and_out(in, out)).warnings; };
  EXPECT_THAT(warnings("[[0, 0, 0], [20, 0.01, 0]]", "[[0, 0, 0], [20, 0.01, 0]]"), IsEmpty());
  EXPECT_THAT(warnings("[[0, 0, 0], [20, 0.01, 0]]", "[[0, 0, 0], [10, 0.005, 0], [20, 0.01, 0]]"), IsEmpty());
  // (40 - 20)/2 steps of 0.01 through 12 cells remain in 480 nodes: rho'/3 of 0.0025
  EXPECT_THAT(
      warnings("[[0, 0, 0], [20, 0.01, 0]]", "[[0, 0, 0], [40, 0.01, 0]]"),
      Contains("boundary.left.flow: the velocities in a space that has no other opening are in balance at their "
               "peaks, but not at all times: they change its pressure by up to 0.000833 Pa"));
  EXPECT_THAT(warnings("[[0, 0.01, 0], [20, 0, 0]]", "[0.01, 0]"),
              Contains(HasSubstr("and go on to change it after the last point of their tables")));
  const std::string ramped = in_and_out("[0.01, 0], ramp_time = 30", "[0.01, 0]");
  EXPECT_THAT(paths(ramped).warnings, Contains(HasSubstr("but not at all times")));
  EXPECT_THAT(paths(ramped + side("top", "type = \"pressure\", pressure = 0")).warnings, IsEmpty());
}

/// Poiseuille's speed between walls, four times that beside one open side, at most g times the duration.
TEST(ForceSpeed, IsThatOfAChannel) {
  const double g = 1e-4, poiseuille = g * 12 * 12 / (8 * 0.1);
  const std::vector<std::string> force{"flow.body_force=[1e-4, 0]"};
  const auto speed = [&](const std::string& shapes, const std::string& sides, std::vector<std::string> more = {}) {
    more.insert(more.end(), force.begin(), force.end());
    return paths(channel(shapes, sides), more).force_speed;
  };
  EXPECT_NEAR(speed("", joined), poiseuille, 1e-12);
  EXPECT_NEAR(speed("", joined, {"boundary.top.flow={ type = \"outflow\" }"}), 4 * poiseuille, 1e-12);
  EXPECT_NEAR(speed("", joined, {"time.steps=50"}), 50 * g, 1e-12);
  const std::string across = side("top", "type = \"periodic\"") + side("bottom", "type = \"periodic\"");
  EXPECT_NEAR(speed("", joined + across), 1e6 * g, 1e-9);
  // half of the length is 6 cells wide: g L/(nu (20 12/12^3 + 20 12/6^3)) is the flow, 3/2 of that over 6 the speed
  const double flow = g * 40 / (0.1 * (20 * 12 / 1728.0 + 20 * 12 / 216.0));
  EXPECT_NEAR(speed(rectangle("[20, 0]", "[40, 6]"), joined), 1.5 * flow / 6, 1e-12);
  const std::string open = side("left", "type = \"pressure\", pressure = 0") + side("right", "type = \"outflow\"");
  EXPECT_NEAR(speed("", open), poiseuille, 1e-12);
  EXPECT_NEAR(speed("", open, {"flow.viscosity=1e-3"}), std::sqrt(2 * g * 40), 1e-12);
  // no way along the force: the pressure carries it
  EXPECT_EQ(speed("", ""), 0);
  EXPECT_EQ(speed("", across), 0);
  EXPECT_EQ(speed(rectangle("[20, 0]", "[23, 12]"), joined), 0);
}

TEST(ForceSpeed, IsCheckedAgainstTheSafeSpeed) {
  for (const auto& [force, safe] : {std::pair{"[1e-4, 0]", true}, {"[2e-3, 0]", false}}) {
    const Simulation simulation(parse_scene(channel("", joined), "a.toml", {std::string("flow.body_force=") + force}));
    int rows = 0;
    for (const Limit& limit : simulation.limits())
      if (limit.name == "Mach number that the body force can reach") {
        ++rows;
        EXPECT_EQ(limit.inside(), safe) << limit.value;
      }
    EXPECT_EQ(rows, 1);
  }
}

/// A run that relies on the limiter says so once, also after a restart, and at its end.
TEST(SpeedLimiter, IsToldOf) {
  Simulation simulation(
      parse_scene(channel("", joined), "a.toml", {"flow.body_force=[1e-3, 0]", "flow.speed_limit=1e-3"}));
  simulation.begin();
  Events events(simulation);
  EXPECT_THAT(events.sum_up(simulation), IsEmpty());
  for (int step = 0; step < 20; ++step) simulation.step();
  const std::vector<std::string> news = events.look_at_row(simulation, simulation.history());
  ASSERT_EQ(news.size(), 1u);
  EXPECT_THAT(news[0], HasSubstr("warning: the speed limiter acts at"));
  EXPECT_THAT(events.look_at_row(simulation, simulation.history()), IsEmpty());
  EXPECT_THAT(Events(simulation, news).look_at_row(simulation, simulation.history()), IsEmpty());
  EXPECT_THAT(events.sum_up(simulation), testing::ElementsAre(HasSubstr("warning: the speed limiter limited")));
  const auto rare = events.look_at_row(simulation, {{"speed_limiter_uses_1", 3}, {"fluid_nodes_1", 480}});
  EXPECT_THAT(rare, IsEmpty());
  EXPECT_THAT(events.sum_up(simulation),
              testing::ElementsAre(testing::StartsWith("the speed limiter limited 3 times")));
}

}  // namespace
}  // namespace vug
