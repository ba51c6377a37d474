// Pores that touch only at corners, and pores that lead around through joined sides.
#include "coupling/fluid_picture.hpp"
#include "unit/channel_paths.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace vug {
namespace {

using namespace test;
using testing::HasSubstr;
using testing::IsEmpty;

/// Rock nodes that touch at their corners, from the bottom at `x` to the top; `more`: as many to the right of each.
std::string diagonal(int x, int more = 0) {
  std::string nodes;
  for (int y = 0; y < 12; ++y) {
    const std::string from = fmt::format("[{}, {}]", x + y, y), to = fmt::format("[{}, {}]", x + y + 1 + more, y + 1);
    nodes += rectangle(from.c_str(), to.c_str());
  }
  return nodes;
}

/// The flow passes between rock nodes that touch at a corner; on D2Q5 nothing else does.
TEST(CornerContacts, AreRemarkedOnWhereTheFlowPassesAndSolutesCannot) {
  const std::string acid = "[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\n", wide = "velocity_set = \"d2q9\"\n";
  const std::string warm = "[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.1\n";
  const auto told = [](const std::string& rock, const std::string& more) { return remarks(channel(rock, more)); };
  EXPECT_THAT(
      told(diagonal(14), pressures + acid),
      testing::ElementsAre(HasSubstr("in 11 places pores touch only at a corner between two rock nodes: the flow "
                                     "passes there, solutes on d2q5 do not")));
  EXPECT_THAT(told(diagonal(14), pressures + warm), testing::ElementsAre(HasSubstr("heat.velocity_set = \"d2q9\"")));
  const auto by_corners = [](const char* what) {
    return testing::ElementsAre(testing::AllOf(
        HasSubstr("pores lead from left to right only through places where they touch at a corner"), HasSubstr(what)));
  };
  EXPECT_THAT(told(diagonal(14), pressures), by_corners("through which the flow passes"));
  EXPECT_THAT(told(diagonal(14), pressures + "[solute]\n" + wide + acid), by_corners("through which the flow passes"));
  std::string still = channel(diagonal(14), acid);
  still.replace(still.find("[flow]"), still.find("[geometry]") - still.find("[flow]"), "");
  EXPECT_THAT(remarks(still), by_corners("solutes on d2q5 do not pass them"));
  EXPECT_THAT(told(diagonal(14, 1), pressures + acid), testing::ElementsAre(HasSubstr("no path of fluid leads from")));
}

/// Flow passes neither into a dead end nor where it has one way out only, but through a pore with two corners.
TEST(CornerContacts, CountOnlyWhereFlowCanPass) {
  const std::string acid = "[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\n";
  const std::string one_way = "[boundary.left]\nflow = { type = \"pressure\", pressure = 0.01 }\n";
  EXPECT_THAT(remarks(channel(diagonal(14), one_way + acid)), IsEmpty());
  // a pore of one node inside rock, which touches the channel at one corner, and at two
  const std::string pore = rectangle("[20, 0]", "[23, 1]") + rectangle("[20, 1]", "[21, 2]") +
                           rectangle("[22, 1]", "[23, 2]") + rectangle("[21, 2]", "[22, 3]");
  const std::string closed = rectangle("[22, 2]", "[23, 3]");
  EXPECT_THAT(remarks(channel(pore + closed, pressures + acid)), IsEmpty());
  EXPECT_THAT(remarks(channel(pore, pressures + acid)), testing::ElementsAre(HasSubstr("in 2 places pores touch")));
}

/// Two blind pores that meet at joined sides lead nowhere.
TEST(JoinedPores, LeadAroundWhereSidesAreJoined) {
  const std::string sides =
      "[boundary.left]\nflow = { type = \"periodic\" }\n[boundary.right]\nflow = { type = \"periodic\" }\n";
  const auto joined = [&](const std::string& rock, const std::string& more = "") {
    const Scene scene = parse_scene(channel(rock, sides + more), "a.toml", {"flow.body_force=[1e-6, 0]"});
    const Simulation simulation(scene);
    return joined_pores(FluidPicture(scene, simulation.parts().geometry)).along_x;
  };
  const std::string blind = rectangle("[10, 0]", "[30, 12]");
  EXPECT_EQ(joined(blind), 0u);
  EXPECT_EQ(joined(rectangle("[10, 0]", "[30, 11]")), 20u * 12 + 20);
  const auto told = testing::Contains(HasSubstr("no path of fluid leads around from left to right"));
  const auto driven = [&](const std::string& rock) {
    const Scene scene = parse_scene(channel(rock, sides), "a.toml", {"flow.body_force=[1e-6, 0]"});
    const Simulation simulation(scene);
    return find_flow_paths(scene, simulation.parts().geometry, simulation.parts().units).warnings;
  };
  EXPECT_THAT(driven(blind), told);
  EXPECT_THAT(driven(rectangle("[10, 0]", "[30, 11]")), testing::Not(told));
  // both pairs of sides are joined, and a wall closes one of them
  const std::string around =
      "[boundary.bottom]\nflow = { type = \"periodic\" }\n[boundary.top]\nflow = { type = \"periodic\" }\n";
  EXPECT_EQ(joined(rectangle("[0, 0]", "[40, 1]"), around), 40u * 11);
  EXPECT_EQ(joined(rectangle("[0, 0]", "[1, 12]"), around), 0u);
}

}  // namespace
}  // namespace vug
