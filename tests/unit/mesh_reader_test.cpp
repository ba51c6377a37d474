// Gmsh meshes: both formats give the same rock.
#include "io/mesh_reader.hpp"

#include "base/require.hpp"
#include "io/assembly_quality.hpp"
#include "support/temporary_folder.hpp"
#include "unit/square_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

namespace vug {
namespace {

using test::square_22;
using test::square_41;
using test::with;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

void expect_square(const Assembly& assembly) {
  ASSERT_EQ(assembly.vertices.size(), 5u);
  EXPECT_THAT(assembly.vertices[2], ElementsAre(1, 1)) << "order of the file, without the unused node";
  EXPECT_THAT(assembly.triangles,
              ElementsAre(std::array{0, 1, 4}, std::array{1, 2, 4}, std::array{2, 3, 4}, std::array{3, 0, 4}));
  EXPECT_THAT(assembly.initial_cracks, ElementsAre(std::array{0, 4}));
  EXPECT_DOUBLE_EQ(assembly_quality(assembly).area, 1);
}

TEST(MeshReader, ReadsBothFormatsToTheSameRock) {
  expect_square(parse_mesh(square_22, "a.msh"));
  expect_square(parse_mesh(square_41, "a.msh"));
}

TEST(MeshReader, TakesGroupsThatRunThroughACurveBackwards) {
  expect_square(parse_mesh(with(square_22, "2 1 2 7 1 5 1", "2 1 2 -7 1 5 1"), "a.msh"));
  const std::string turned = with(square_41, "4 0 0 0 1 1 0 1 7 2 1 -1", "4 0 0 0 1 1 0 1 -7 2 1 -1");
  expect_square(parse_mesh(turned, "a.msh"));
  const Assembly rock = parse_mesh(with(turned, "3 0 0 0 1 1 0 1 8 2 4 5", "3 0 0 0 1 1 0 1 -8 2 4 5"), "a.msh");
  EXPECT_THAT(rock.groups.at("the rock"), ElementsAre(0, 1, 2, 3));
}

TEST(MeshReader, KnowsTheTrianglesOfNamedSurfaces) {
  for (const std::string& text : {square_22, square_41}) {
    const Assembly rock = parse_mesh(text, "square.msh");
    ASSERT_EQ(rock.groups.size(), 1u);
    EXPECT_THAT(rock.groups.at("the rock"), ElementsAre(0, 1, 2, 3));
  }
}

/// A surface of format 4.1 lists all groups that it is in.
TEST(MeshReader, KnowsASurfaceInSeveralGroups) {
  std::string text = with(square_41, "2\n1 7 \"crack\"", "4\n1 7 \"crack\"\n2 9 \"all\"\n2 3 \"left\"");
  text = with(text, "3 0 0 0 1 1 0 1 8 2 4 5", "3 0 0 0 1 1 0 3 8 -3 9 2 4 5");
  const Assembly rock = parse_mesh(text, "square.msh");
  expect_square(rock);
  ASSERT_EQ(rock.groups.size(), 3u);
  for (const char* name : {"the rock", "all", "left"})
    EXPECT_THAT(rock.groups.at(name), ElementsAre(0, 1, 2, 3)) << name;
}

/// Format 2.2 repeats an element for every group that it is in.
TEST(MeshReader, KnowsATriangleInSeveralGroups) {
  std::string text = with(square_22, "2\n1 7 \"crack\"", "3\n1 7 \"crack\"\n2 9 \"left\"");
  text = with(text, "$Elements\n6\n", "$Elements\n7\n");
  const Assembly rock = parse_mesh(with(text, "6 2 2 8 1 4 1 5\n", "6 2 2 8 1 4 1 5\n7 2 2 9 1 4 1 5\n"), "a.msh");
  expect_square(rock);
  EXPECT_THAT(rock.groups.at("the rock"), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(rock.groups.at("left"), ElementsAre(3));
}

TEST(MeshReader, ReadsLineEndsOfEverySystem) {
  std::string text;
  for (const char c : square_22) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  expect_square(parse_mesh(text, "a.msh"));
}

TEST(MeshReader, ReadsFromAFileAndNamesOneThatIsMissing) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.msh", square_41);
  expect_square(read_mesh(folder / "a.msh"));
  try {
    read_mesh(folder / "b.msh");
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("b.msh: does not exist"));
  }
}

TEST(MeshReader, ReadsWhatGmshWrites) {
  if (std::system("gmsh -version > /dev/null 2>&1") != 0) GTEST_SKIP() << "gmsh is not installed";
  const test::TemporaryFolder folder;
  test::write_text(folder / "rock.geo", R"(SetFactory("Built-in");
l = 0.004;
Point(1) = {0, 0, 0, l}; Point(2) = {0.1, 0, 0, l}; Point(3) = {0.1, 0.07, 0, l}; Point(4) = {0, 0.07, 0, l};
Point(5) = {0.03, 0.035, 0, l}; Point(6) = {0.06, 0.04, 0, l};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1}; Line(5) = {5, 6};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Line{5} In Surface{1};
Physical Surface("rock") = {1}; Physical Curve("notch") = {5};
)");
  for (const std::string format : {"msh22", "msh41"}) {
    const auto path = folder / (format + ".msh");
    const auto command =
        "gmsh -2 -algo del2d -format " + format + " -o " + path + " " + (folder / "rock.geo") + " > /dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    const auto assembly = read_mesh(path);
    EXPECT_NEAR(assembly_quality(assembly).area, 0.007, 1e-12);
    double length = 0;
    for (const auto& c : assembly.initial_cracks)
      length += std::hypot(assembly.vertices[c[0]][0] - assembly.vertices[c[1]][0],
                           assembly.vertices[c[0]][1] - assembly.vertices[c[1]][1]);
    EXPECT_NEAR(length, std::hypot(0.03, 0.005), 1e-12);
  }
}

}  // namespace
}  // namespace vug
