// What the geometry makes of the conditions on the fluid: speeds, pressures and times that they need.
#include "unit/channel_paths.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace vug {
namespace {

using test::channel;
using test::inflow;
using test::outlet;
using test::paths;
using test::pressures;
using test::rectangle;
using test::refusal;
using test::wall;
using testing::HasSubstr;

double passage_speed(const std::string& text) {
  return paths(text).passage_speed;
}

/// 12 nu q/n^3 per cell between two walls, a quarter of that beside one that slides, none without walls.
TEST(FlowPaths, KnowThePressureThatAVelocityNeeds) {
  const double needed = 12 * 0.1 * (0.02 * 12) * 40 / (12.0 * 12 * 12);
  const auto pressure = [](const std::string& sides) { return paths(channel("", sides)).passage_pressure; };
  EXPECT_NEAR(pressure(inflow + outlet), needed, 1e-12);
  const std::string slides = "[boundary.top]\nflow = { type = \"wall\", velocity = [0.02, 0] }\n";
  EXPECT_NEAR(pressure(inflow + outlet + slides), needed / 4, 1e-12);
  const std::string joined =
      "[boundary.top]\nflow = { type = \"periodic\" }\n[boundary.bottom]\nflow = { type = \"periodic\" }\n";
  EXPECT_EQ(pressure(inflow + outlet + joined), 0);
  EXPECT_EQ(pressure(pressures), 0);
  // half of its length, between slabs of two cells on either side, is as narrow as 8 cells
  const std::string slabs = rectangle("[20, 0]", "[40, 2]") + rectangle("[20, 10]", "[40, 12]");
  EXPECT_NEAR(paths(channel(slabs, inflow + outlet)).passage_pressure, needed / 2 * (1 + std::pow(12 / 8.0, 3)),
              0.1 * needed);
  // there are four slits of two cells, which carry 4 n^3 instead of (4 n)^3
  const std::string comb =
      rectangle("[20, 2]", "[40, 3]") + rectangle("[20, 5]", "[40, 7]") + rectangle("[20, 9]", "[40, 10]");
  EXPECT_NEAR(paths(channel(comb, inflow + outlet)).passage_pressure,
              needed / 2 * (1 + std::pow(12, 3) / (4 * std::pow(2, 3))), 0.05 * needed / 2 * 54);
}

/// The slowest mode of a channel, 36 nu L^2/(pi n)^2 between pressures, four times that behind a velocity.
TEST(FlowPaths, KnowHowLongTheFlowNeedsToSettle) {
  const double time = 36 * 0.1 * 40 * 40 / (12 * 12 * std::numbers::pi * std::numbers::pi);
  EXPECT_NEAR(paths(channel("", pressures)).settling_steps, time, 0.03 * time);
  EXPECT_NEAR(paths(channel("", inflow + outlet)).settling_steps, 4 * time, 0.03 * 4 * time);
}

/// n^2/(8 L) of a plane channel; a wider part does not raise it, and nothing bounds a flow that no wall holds back.
TEST(FlowPaths, KnowHowFastViscosityLetsAPressureDriveIt) {
  const auto speed = [](const std::string& shapes, const std::string& sides) {
    return paths(channel(shapes, sides)).pressed.speed / 0.01;  // of the pressure
  };
  const std::string joined =
      "[boundary.top]\nflow = { type = \"periodic\" }\n[boundary.bottom]\nflow = { type = \"periodic\" }\n";
  EXPECT_NEAR(speed("", pressures), 12 * 12 / (8 * 40.0), 1e-12);
  EXPECT_EQ(speed("", inflow + outlet), 0);
  EXPECT_EQ(speed("", pressures + joined), std::numeric_limits<double>::infinity());
  const std::string slabs = rectangle("[0, 0]", "[40, 2]") + rectangle("[0, 10]", "[40, 12]");
  EXPECT_NEAR(speed(slabs, pressures), 8 * 8 / (8 * 40.0), 1e-12);
  // a slit of 4 cells over 10 nodes between wide ends, where nearly all of the pressure falls
  const std::string slit = rectangle("[15, 0]", "[25, 4]") + rectangle("[15, 8]", "[25, 12]");
  EXPECT_NEAR(speed(slit, pressures), 4 * 4 / (8 * 10.0), 0.2 * 4 * 4 / (8 * 10.0));
}

TEST(FlowPaths, NothingMovesFasterThanTheSchemeFollows) {
  EXPECT_THAT(refusal(channel("", "[boundary.top]\nflow = { type = \"wall\", velocity = [0.6, 0] }\n")),
              HasSubstr("boundary.top.flow.velocity is 0.6 cells in a time step, and above 0.5 no run is stable"));
  EXPECT_EQ(refusal(channel("", "[boundary.top]\nflow = { type = \"wall\", velocity = [0.4, 0] }\n")), "");
}

/// A rate is spread by the ratio of a share to the mean over the fluid: 12 cells of it, or the lower 6 beside a block.
TEST(FlowPaths, SpeedOfARateFollowsTheFormOfItsProfile) {
  const auto rate = [](const char* value, const char* table) {
    return std::string("[boundary.left]\nflow = { type = \"velocity\", flow_rate = ") + value +
           ", profile = \"table\", profile_table = " + table + " }\n" + outlet;
  };
  EXPECT_EQ(refusal(channel("", rate("2.4", "[[0, 3], [12, 3]]"))), "");
  EXPECT_THAT(refusal(channel("", rate("12", "[[0, 0.1], [12, 0.1]]"))),
              HasSubstr("boundary.left.flow.flow_rate is 1 cells in a time step"));
  EXPECT_THAT(refusal(channel("", rate("-4.8", "[[0, 0], [12, 2]]"))),
              HasSubstr("boundary.left.flow.flow_rate is 0.8 cells in a time step"));
  const std::string block = rectangle("[0, 6]", "[5, 12]");
  EXPECT_EQ(refusal(channel(block, rate("2.4", "[[0, 3], [12, 3]]"))), "");
  EXPECT_THAT(refusal(channel(block, rate("4.8", "[[0, 3], [12, 3]]"))), HasSubstr("is 0.8 cells in a time step"));
  EXPECT_EQ(
      refusal(channel(block, rate("2.4", "[[0, -1], [6, -1], [6.001, 2], [12, 2]]"))),
      "a.toml: the shares of boundary.left.flow.profile_table beside fluid have no positive sum, and flow_rate is "
      "spread by them");
}

TEST(FlowPaths, SpeedOfAParabolicRateIsThatOfItsMiddle) {
  const auto rate = [](const char* value) {
    return std::string("[boundary.left]\nflow = { type = \"velocity\", profile = \"parabolic\", flow_rate = ") + value +
           " }\n" + outlet;
  };
  EXPECT_EQ(refusal(channel("", rate("3.9"))), "");
  EXPECT_THAT(refusal(channel("", rate("4.8"))), HasSubstr("flow_rate is 0.6 cells in a time step"));
}

/// By continuity: 12 cells of inflow go through what is left open.
TEST(FlowPaths, SpeedInTheNarrowestPassageIsThatOfContinuity) {
  EXPECT_DOUBLE_EQ(passage_speed(channel("", inflow + outlet)), 0.02);
  EXPECT_DOUBLE_EQ(passage_speed(channel(rectangle("[20, 0]", "[23, 9]"), inflow + outlet)), 0.02 * 12 / 3);
  EXPECT_DOUBLE_EQ(
      passage_speed(channel(rectangle("[20, 0]", "[23, 5]") + rectangle("[20, 7]", "[23, 12]"), inflow + outlet)),
      0.02 * 12 / 2);
  // not what lies behind the outlet: a dead end
  const std::string beside = "[boundary.top]\nflow = { type = \"outflow\" }\n";
  EXPECT_DOUBLE_EQ(passage_speed(channel(rectangle("[20, 0]", "[23, 11]"), inflow + beside)), 0.02);
  // an outlet right beside the inflow, and narrower
  const std::string corner =
      "[boundary.injection]\nside = \"top\"\ncentre = 1.5\nwidth = 3\nflow = { type = \"outflow\" }\n";
  EXPECT_DOUBLE_EQ(passage_speed(channel("", inflow + corner)), 0.02 * 12 / 3);
  EXPECT_EQ(passage_speed(channel("", pressures)), 0);
}

/// Whether it enters by one side or by two injections on it, of which neither is a way out for the other.
TEST(FlowPaths, InflowsIntoOnePoreAddUp) {
  const auto injection = [](const char* name, const char* centre) {
    return std::string("[[boundary.injection]]\nname = \"") + name + "\"\nside = \"left\"\ncentre = " + centre +
           "\nwidth = 6\nflow = { type = \"velocity\", velocity = [0.02, 0] }\n";
  };
  const std::string throat = rectangle("[20, 0]", "[23, 9]");
  const FlowPaths one = paths(channel(throat, inflow + outlet));
  const FlowPaths two = paths(channel(throat, injection("a", "3") + injection("b", "9") + outlet));
  EXPECT_DOUBLE_EQ(two.passage_speed, one.passage_speed);
  EXPECT_DOUBLE_EQ(two.passage_peak, one.passage_peak);
  EXPECT_DOUBLE_EQ(two.passage_pressure, one.passage_pressure);
  // each in a pore of its own
  const std::string parted = rectangle("[0, 5]", "[40, 7]") + rectangle("[20, 0]", "[23, 4]");
  EXPECT_DOUBLE_EQ(passage_speed(channel(parted, injection("a", "3") + injection("b", "9") + outlet)), 0.02 * 5);
}

/// What wells draw behind a throat adds up as what they push does. A given draw is no outlet: a small one beside the
/// inflow takes its own rate, all else passes the throat; only one whose rate changes is not relied upon.
TEST(FlowPaths, GivenRatesTakeWhatTheyTakeAndNoMore) {
  const auto rate = [](const char* side, const char* centre, const char* width, const char* value) {
    return fmt::format(
        "[[boundary.injection]]\nname = \"{0}{1:.1}\"\nside = \"{0}\"\ncentre = {1}\nwidth = {2}\nflow = "
        "{{ type = \"velocity\", flow_rate = {3} }}\n",
        side, centre, width, value);
  };
  const std::string throat = rectangle("[20, 0]", "[23, 9]");
  const std::string reservoir = "[boundary.left]\nflow = { type = \"pressure\", pressure = 0 }\n";
  const FlowPaths one = paths(channel(throat, inflow + outlet));
  const FlowPaths drawn =
      paths(channel(throat, reservoir + rate("right", "3", "6", "-0.12") + rate("right", "9", "6", "-0.12")));
  EXPECT_DOUBLE_EQ(drawn.passage_speed, one.passage_speed);
  EXPECT_DOUBLE_EQ(drawn.passage_peak, one.passage_peak);
  EXPECT_NEAR(drawn.passage_pressure, one.passage_pressure, 1e-12);
  const auto beside = [&](const char* value) {
    return paths(channel(throat, inflow + outlet + rate("top", "3.5", "3", value))).passage_speed;
  };
  EXPECT_DOUBLE_EQ(beside("-0.006"), (0.02 * 12 - 0.006) / 3);
  EXPECT_DOUBLE_EQ(beside("-0.21"), 0.21 / 3) << "what the draw itself takes";
  EXPECT_DOUBLE_EQ(beside("[[0, 0], [5, -0.21]]"), 0.02 * 12 / 3);
}

/// The pressure is that of the highest viscosity of the temperatures that the case names.
TEST(FlowPaths, ColdFluidNeedsMorePressure) {
  const auto pressure = [](const char* temperature) {
    std::string text = channel("",
                               "[boundary.left]\nflow = { type = \"velocity\", velocity = [0.02, 0] }\nheat = { type = "
                               "\"temperature\", temperature = " +
                                   std::string(temperature) + " }\n" + outlet);
    text.insert(text.find("density"), "viscosity_table = [[280, 0.4], [300, 0.1], [320, 0.05]]\n");
    text.replace(text.find("viscosity = 0.1\n"), std::string("viscosity = 0.1\n").size(), "");
    text += "[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.1\ninitial_temperature = 300\n";
    return paths(text).passage_pressure;
  };
  const double needed = 12 * 0.1 * (0.02 * 12) * 40 / (12.0 * 12 * 12);
  EXPECT_NEAR(pressure("300"), needed, 1e-12);
  EXPECT_NEAR(pressure("320"), needed, 1e-12);
  EXPECT_NEAR(pressure("280"), 4 * needed, 1e-12);
}

}  // namespace
}  // namespace vug
