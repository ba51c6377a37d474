// What the geometry makes of the conditions on the fluid: mistakes are refused, what may be meant is remarked on.
#include "support/cracked_rock.hpp"
#include "unit/channel_paths.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace vug {
namespace {

using test::channel;
using test::dissolving;
using test::inflow;
using test::outlet;
using test::pressures;
using test::rectangle;
using test::refusal;
using test::remarks;
using test::wall;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(FlowPaths, AParabolaOverRockIsRemarkedOn) {
  const std::string slabs = rectangle("[0, 0]", "[40, 2]") + rectangle("[0, 10]", "[40, 12]");
  const std::string parabola =
      "[boundary.left]\nflow = { type = \"velocity\", velocity = [0.02, 0], profile = \"parabolic\" }\n";
  EXPECT_THAT(remarks(channel(slabs, parabola + outlet)),
              Contains(HasSubstr("boundary.left.flow.profile: the parabola spans all 12 nodes there, 4 of which are")));
  EXPECT_THAT(remarks(channel("", parabola + outlet)), IsEmpty());
  EXPECT_THAT(remarks(channel(slabs, inflow + outlet)), IsEmpty());
  const std::string injection =
      "[boundary.injection]\nside = \"left\"\ncentre = 6\nwidth = 8\n"
      "flow = { type = \"velocity\", velocity = [0.02, 0], profile = \"parabolic\" }\n";
  EXPECT_THAT(remarks(channel(slabs, injection + outlet)), IsEmpty());
}

TEST(FlowPaths, APressureThatChangesBeforeAnOutflowIsRemarkedOn) {
  const std::string held = "[boundary.right]\nflow = { type = \"pressure\", pressure = 0 }\n";
  for (const char* given : {"0.01, ramp_time = 50", "[[0, 0], [50, 0.01]]"}) {
    const std::string changing =
        fmt::format("[boundary.left]\nflow = {{ type = \"pressure\", pressure = {} }}\n", given);
    EXPECT_THAT(remarks(channel("", changing + outlet)),
                Contains(HasSubstr("boundary.left.flow changes its pressure, and boundary.right.flow is an outflow: it "
                                   "holds back changes of the flow as 160 more cells of fluid")));
    EXPECT_THAT(remarks(channel("", changing + held)), IsEmpty());
  }
  EXPECT_THAT(remarks(channel("", "[boundary.left]\nflow = { type = \"pressure\", pressure = 0.01 }\n" + outlet)),
              IsEmpty());
}

/// At tau = 0.8, 8 Lambda = 2.4 (1/1.92 - 1/2) = 0.05 in one row and 1 + (0.05 - 1)/4 in two.
TEST(FlowPaths, PassagesThatTheCollisionShutsAreRemarkedOn) {
  const auto through = [](const char* collision, const std::string& shapes) {
    std::string text = channel(shapes, inflow + outlet);
    return remarks(text.insert(text.find("viscosity"), fmt::format("collision = \"{}\"\n", collision)));
  };
  const std::string slot = rectangle("[20, 0]", "[23, 5]") + rectangle("[20, 6]", "[23, 12]");
  const std::string wider = rectangle("[20, 0]", "[23, 5]") + rectangle("[20, 7]", "[23, 12]");
  EXPECT_THAT(through("lallemand_luo", slot),
              ElementsAre(HasSubstr("flow.collision: 3 of 447 fluid nodes are in passages one cell wide, which carry "
                                    "0.05 of what flows between plates (two cells: 0.76); trt carries 1.5 and 1.1")));
  EXPECT_THAT(through("lallemand_luo", wider), IsEmpty());
  for (const char* open : {"trt", "bgk", "regularised"}) EXPECT_THAT(through(open, slot), IsEmpty()) << open;
}

/// The drag of a crack narrower than a cell is made for what `trt` carries in a row of nodes.
TEST(FlowPaths, CracksThatTheCollisionShutsAreRemarkedOn) {
  const auto gaping = [](const char* collision) {
    const Scene scene = parse_scene(test::cracked_rock, "a.toml",
                                    {"damage.aperture=\"opening\"", fmt::format("flow.collision=\"{}\"", collision)});
    const Simulation simulation(scene);
    return find_flow_paths(scene, simulation.parts().geometry, simulation.parts().units).warnings;
  };
  const auto told = Contains(HasSubstr("flow.collision: a crack narrower than a cell conducts as it gapes with trt"));
  EXPECT_THAT(gaping("lallemand_luo"), told);
  EXPECT_THAT(gaping("trt"), Not(told));
}

/// A temperature of a side is that of rock and fluid: 8 of 12 nodes. Not remarked on: walls and outflows, an injection
/// as wide as the fluid, cells of fluid in front of the rock, a wall of one cell.
TEST(FlowPaths, RockAtTheTemperatureOfTheInflowIsRemarkedOn) {
  const std::string warm = "[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.1\ninitial_temperature = 300\n";
  const std::string given = "heat = { type = \"temperature\", temperature = 350 }\n";
  const auto slabs = [](const std::string& begin) {
    return rectangle(("[" + begin + ", 0]").c_str(), "[40, 4]") + rectangle(("[" + begin + ", 8]").c_str(), "[40, 12]");
  };
  const auto told =
      Contains(HasSubstr("boundary.left.heat: 8 of the 12 nodes there are rock, which is kept at the given"));
  const std::string pressed = "[boundary.left]\nflow = { type = \"pressure\", pressure = 0.01 }\n";
  EXPECT_THAT(remarks(channel(slabs("0"), warm + inflow + given + outlet)), told);
  EXPECT_THAT(remarks(channel(slabs("0"), warm + pressed + given + outlet)), told);
  EXPECT_THAT(remarks(channel(slabs("0"), warm + inflow + "heat = { type = \"outflow\" }\n" + outlet)), Not(told));
  EXPECT_THAT(remarks(channel(slabs("0"), warm + "[boundary.left]\n" + given + outlet)), Not(told));
  EXPECT_THAT(remarks(channel(slabs("2"), warm + inflow + given + outlet)), Not(told));
  EXPECT_THAT(remarks(channel(rectangle("[0, 0]", "[40, 1]"), warm + inflow + given + outlet)),
              Not(Contains(HasSubstr("are rock, which is kept"))));
  const std::string injection =
      "[boundary.injection]\nside = \"left\"\ncentre = 6\nwidth = 4\n" + inflow.substr(inflow.find('\n') + 1) + given;
  EXPECT_THAT(remarks(channel(slabs("0"), warm + injection + outlet)),
              Not(Contains(HasSubstr("are rock, which is kept"))));
}

TEST(FlowPaths, OrdinaryChannelsAreNotRemarkedOn) {
  EXPECT_THAT(remarks(channel("", pressures)), IsEmpty());
  EXPECT_THAT(remarks(channel("", inflow + outlet)), IsEmpty());
  EXPECT_THAT(remarks(channel(rectangle("[20, 0]", "[23, 11]"), pressures)), IsEmpty());
  // fluid goes through between two corners that touch, and something is open
  EXPECT_THAT(remarks(channel(rectangle("[20, 0]", "[21, 6]") + rectangle("[21, 6]", "[22, 11]"), pressures)),
              IsEmpty());
  EXPECT_THAT(remarks(channel("", inflow + "[boundary.right]\nflow = { type = \"velocity\", velocity = [0.02, 0] }\n")),
              IsEmpty());
}

TEST(FlowPaths, GeometryWithoutFluidIsRefused) {
  const std::string solid = rectangle("[0, 0]", "[40, 12]");
  EXPECT_EQ(refusal(channel(solid, "")), "a.toml: the geometry has no fluid node, and [flow] is only in fluid");
  EXPECT_THAT(refusal("[lattice]\nsize = [0.04, 0.02]\nspacing = 5e-4\ntime_step = 1e-5\n[time]\nsteps = 10\n"
                      "[geometry]\ntype = \"rock\"\n[rock]\nelement_size = 4e-3\nporosity = 0.003\n"
                      "[flow]\nviscosity = 1e-3\n"),
              HasSubstr("[flow] is only in fluid: rock.porosity = 0.003 is less than one pathway"));
  const std::string heat_alone =
      "[lattice]\nsize = [40, 12]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 10\n[heat]\n"
      "fluid_diffusivity = 0.1\nsolid_diffusivity = 0.1\n[geometry]\ntype = \"shapes\"\n" +
      solid;
  EXPECT_EQ(refusal(heat_alone), "");
}

TEST(FlowPaths, WallBetweenInletAndOutletIsRemarkedOn) {
  EXPECT_THAT(
      remarks(channel(wall, pressures)),
      testing::ElementsAre("no path of fluid leads from boundary.left to another open side or shape: nothing flows"));
  EXPECT_THAT(remarks(channel(wall, pressures + dissolving)), Contains(HasSubstr("nothing flows until rock opens")));
}

TEST(FlowPaths, InflowWithoutAWayOutIsRefused) {
  const std::string message = "a.toml: boundary.left.flow presses fluid into a space that has no other opening";
  EXPECT_EQ(refusal(channel("", inflow)), message);
  EXPECT_EQ(refusal(channel(wall, inflow + outlet)), message);
  EXPECT_THAT(refusal(channel("", "[boundary.left]\nflow = { type = \"velocity\", velocity = [-0.02, 0] }\n")),
              HasSubstr("draws fluid out of a space"));
  EXPECT_THAT(remarks(channel(wall, inflow + outlet + dissolving)),
              Contains(HasSubstr("has no other opening until rock opens")));
  // what is pressed in here leaves there, as it does around the two ends of a lattice
  EXPECT_EQ(
      refusal(channel(
          "", "[boundary.left]\nflow = { type = \"periodic\" }\n[boundary.right]\nflow = { type = \"periodic\" }\n")),
      "");
}

/// By the lengths of the two outlines, 4 pi cells and 10; what is left over is more than rounding of the given speeds.
TEST(FlowPaths, WellAndDrainOfAClosedBoxMustBalance) {
  const std::string shapes =
      "[[geometry.shapes]]\ntype = \"disc\"\nname = \"well\"\ncentre = [10, 6]\nradius = 2\n"
      "[[geometry.shapes]]\ntype = \"rectangle\"\nname = \"drain\"\nfrom = [28, 5]\nto = [31, 7]\n"
      "[boundary.shape.well]\nflow = { type = \"velocity\", speed = 0.01 }\n";
  const auto drain = [](const char* speed) {
    return std::string("[boundary.shape.drain]\nflow = { type = \"velocity\", speed = ") + speed + " }\n";
  };
  EXPECT_EQ(refusal(channel(shapes, drain("-0.01256637"))), "");
  EXPECT_THAT(refusal(channel(shapes, drain("-0.0123"))), HasSubstr("presses fluid into a space"));
  EXPECT_THAT(refusal(channel(shapes, drain("-0.0128"))), HasSubstr("draws fluid out of a space"));
}

TEST(FlowPaths, InjectionIntoRockIsRefusedUnlessRockOpens) {
  const std::string injection =
      "[boundary.injection]\nside = \"left\"\ncentre = 3\nwidth = 2\nflow = { type = \"pressure\", pressure = 0.01 }\n"
      "[boundary.right]\nflow = { type = \"pressure\", pressure = 0 }\n";
  const std::string block = rectangle("[0, 0]", "[5, 6]");
  EXPECT_EQ(refusal(channel(block, injection)), "a.toml: boundary.injection.flow has no effect: no fluid touches it");
  EXPECT_THAT(remarks(channel(block, injection + dissolving)),
              Contains("boundary.injection.flow has no effect until rock opens: no fluid touches it"));
  EXPECT_THAT(remarks(channel(rectangle("[0, 0]", "[5, 12]"), pressures)),
              Contains("boundary.left.flow has no effect: no fluid touches it"));
}

TEST(FlowPaths, ShapeThatNoFluidTouchesIsRefusedUnlessRockOpens) {
  const std::string sides = pressures + "[boundary.shape.well]\nflow = { type = \"pressure\", pressure = 0.01 }\n";
  const std::string well = rectangle("[15, 3]", "[25, 9]") +
                           "[[geometry.shapes]]\ntype = \"disc\"\nname = \"well\"\ncentre = [20, 6]\nradius = 1.5\n";
  const std::string message = "a.toml: boundary.shape.well.flow has no effect: no fluid touches it";
  EXPECT_EQ(refusal(channel(well, sides)), message);
  EXPECT_THAT(remarks(channel(well, sides + dissolving)),
              Contains("boundary.shape.well.flow has no effect until rock opens: no fluid touches it"));
  const std::string reacting = std::regex_replace(dissolving, std::regex("molar_volume = 1e-3"), "molar_volume = 0");
  EXPECT_EQ(refusal(channel(well, sides + reacting)), message) << "rock that only reacts never opens";
}

TEST(FlowPaths, ShapesThatLeaveNoTraceAreRemarkedOn) {
  EXPECT_THAT(parse_scene(channel(rectangle("[10.6, 3]", "[11.4, 5]"), pressures), "a.toml").warnings,
              testing::ElementsAre("geometry.shapes.0 holds the centre of no cell and leaves no trace on the lattice"));
  EXPECT_THAT(parse_scene(channel(rectangle("[10.4, 3]", "[10.6, 5]"), pressures), "a.toml").warnings, IsEmpty());
}

}  // namespace
}  // namespace vug
