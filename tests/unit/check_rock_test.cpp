// What vug check says about the triangles of rock, drawn or read.
#include "base/require.hpp"
#include "coupling/check.hpp"
#include "support/meshed_rock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug {
namespace {

using testing::HasSubstr;

/// By the smallest triangle, drawn or read: as large as an equilateral one with edges of four cells, of 6.93 cells
/// area.
TEST(Check, RemarksOnTrianglesTooSmallForTheLattice) {
  const std::string rock =
      "[lattice]\nsize = [40, 30]\nspacing = 1\ntime_step = 1e-6\n[time]\nsteps = 10\n[geometry]\ntype = \"rock\"\n"
      "[mechanics]\n";
  const std::string heat = "[heat]\nfluid_diffusivity = 1e3\nsolid_diffusivity = 1e3\n";
  const auto remarks = [&](const std::string& key, bool alone = false) {
    return check_case(parse_scene(alone ? rock : rock + heat, "a.toml", {key})).warnings;
  };
  const test::TemporaryFolder folder;
  const std::string file = folder / "rock.msh", mesh = "rock.mesh=\"" + file + "\"";
  const auto of_mesh = [&](double height) {  // two triangles, the smaller 4 cells wide and that high
    test::write_text(file, test::mesh_text({{10, 10}, {14, 10}, {12, 10 + height}, {12, 6}}, {{0, 1, 2}, {1, 0, 3}}));
    return remarks(mesh);
  };
  const auto remark = testing::Contains(HasSubstr("is below four cells: too small for the lattice"));
  EXPECT_THAT(of_mesh(3.4), remark);
  EXPECT_THAT(of_mesh(3.5), testing::Not(remark));
  EXPECT_THAT(remarks("rock.element_size=3.5"), remark);
  EXPECT_THAT(remarks("rock.element_size=3.5", true), testing::Not(remark));  // nothing is computed on the lattice
  EXPECT_THAT(remarks("rock.element_size=10"), testing::Not(remark));
}

/// Four triangles around the middle of a square, mean edge 17.1 cells: at a pathway factor of 1 broken bonds are 9.86
/// cells wide, whatever the least width.
TEST(Check, RemarksOnNotchesOfAMeshByItsOwnTriangles) {
  const test::TemporaryFolder folder;
  std::string mesh =
      test::mesh_text({{10, 5}, {30, 5}, {30, 25}, {10, 25}, {20, 15}}, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
  const auto replace = [&](const std::string& from, const std::string& to) {
    mesh.replace(mesh.find(from), from.size(), to);
  };
  replace("$Nodes", "$PhysicalNames\n1\n1 7 \"crack\"\n$EndPhysicalNames\n$Nodes");
  replace("$Elements\n4\n", "$Elements\n5\n5 1 2 7 1 1 5\n");
  test::write_text(folder / "rock.msh", mesh);
  const auto remarks = [&](const std::string& set) {
    return check_case(parse_scene("[lattice]\nsize = [40, 30]\nspacing = 1\ntime_step = 1e-6\n[time]\nsteps = 10\n"
                                  "[geometry]\ntype = \"rock\"\n[rock]\nmesh = \"" +
                                      (folder / "rock.msh") +
                                      "\"\n[[rock.notches]]\nfrom = [10, 5]\nto = [20, 15]\naperture = 5\n"
                                      "[mechanics]\n[damage]\n[flow]\nviscosity = 1e3\n",
                                  "a.toml", {set}))
        .warnings;
  };
  const auto widened = HasSubstr("only until the first update");
  EXPECT_THAT(
      remarks("damage.pathway_factor=1"),
      testing::Contains(HasSubstr("rock.notches.0 is 5 cells wide only until the first update, and about 9.86 "
                                  "wide from then on, like every broken bond: lower damage.pathway_factor to")));
  EXPECT_THAT(remarks("damage.pathway_factor=0.2"), testing::Not(testing::Contains(widened)));
  EXPECT_THAT(remarks("damage.minimum_aperture=6"), testing::Contains(HasSubstr("about 6 wide from then on")));
}

/// What is advised of coarse triangles can be done, and is enough for triangles and lattice.
TEST(Check, AdvisesWhatCanBeDoneAboutCoarseTriangles) {
  const std::string rock = VUG_SOURCE_DIR "/cases/tutorial/rock.toml";
  const auto advice = [](const CheckReport& report) {
    for (const Limit& limit : report.limits)
      if (limit.name == "mean edge of the bonds" && !limit.inside()) return limit.advice;
    return std::string();
  };
  const std::string told = advice(check_case(read_scene(rock)));
  ASSERT_THAT(told, testing::MatchesRegex(".* lower rock.element_size \\(of a mesh, its edges\\) to [^ ]* m, and "
                                          "lattice.spacing to [^ ]* m"));
  const auto number = [&](const std::string& key) {
    const auto value = told.find(" to ", told.find(key)) + 4;
    return key + "=" + std::to_string(std::stod(told.substr(value)));
  };
  const CheckReport followed = check_case(read_scene(rock, {number("rock.element_size"), number("lattice.spacing")}));
  EXPECT_EQ(advice(followed), "");
  EXPECT_THAT(followed.warnings, testing::Not(testing::Contains(HasSubstr("below four cells"))));
  EXPECT_EQ(advice(check_case(read_scene(rock, {"mechanics.bond.fracture_energy_I=1e-9"}))),
            "bonds snap at once and dissipate what they hold, whatever their fracture energy");
  const std::string without = told.substr(0, told.find(", and lattice.spacing"));
  EXPECT_EQ(advice(check_case(read_scene(rock, {"lattice.spacing=2e-4"}))), without);
  EXPECT_EQ(advice(check_case(read_scene(VUG_SOURCE_DIR "/cases/laboratory/compression.toml"))), without);
}

/// A mesh in millimetres is a thousand times too large; one of another size is somewhere else.
TEST(Check, SaysThatAMeshIsInMillimetres) {
  const test::TemporaryFolder folder;
  const auto refusal = [&](double side) {
    test::write_text(folder / "square.msh",
                     test::mesh_text({{0, 0}, {side, 0}, {side, side}, {0, side}}, {{0, 1, 2}, {0, 2, 3}}));
    try {
      check_case(
          parse_scene("[lattice]\nsize = [0.1, 0.1]\nspacing = 1e-3\ntime_step = 1e-6\n[time]\nsteps = 1\n"
                      "[geometry]\ntype = \"rock\"\n[mechanics]\n[rock]\nmesh = \"" +
                          (folder / "square.msh") + "\"\n",
                      "a.toml"));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(0.1), "");
  const std::string outside = "m lies outside the lattice, which is [0, 0.1] x [0, 0.1] m";
  EXPECT_THAT(refusal(100), testing::EndsWith(outside + "; a mesh in millimetres is to be written in metres"));
  for (const double side : {0.2, 10.0, 101.0}) EXPECT_THAT(refusal(side), testing::EndsWith(outside)) << side;
}

}  // namespace
}  // namespace vug
