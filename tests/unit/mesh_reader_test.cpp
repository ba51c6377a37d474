// Gmsh meshes: both formats give the same rock, and whatever is wrong is said with its line.
#include "io/mesh_reader.hpp"

#include "base/require.hpp"
#include "io/assembly_quality.hpp"
#include "support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace vug {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A unit square of four triangles around its centre; the edge 1-5 is a crack. Node 9 belongs to nobody, the second
// triangle is written clockwise.
const std::string square_22 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$Comments
made by hand
$EndComments
$PhysicalNames
2
1 7 "crack"
2 8 "the rock"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1 0 0
9 0.25 0.5 0
3 1 1 0
4 0 1 0
5 0.5 5e-1 0
$EndNodes
$Elements
6
1 15 2 0 1 1
2 1 2 7 1 5 1
3 2 2 8 1 1 2 5
4 2 2 8 1 2 5 3
5 2 2 8 1 3 4 5
6 2 2 8 1 4 1 5
$EndElements
)";

const std::string square_41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "crack"
2 8 "the rock"
$EndPhysicalNames
$Entities
1 2 1 0
1 0 0 0 0
4 0 0 0 1 1 0 1 7 2 1 -1
5 0 0 0 1 1 0 0 2 1 -1
3 0 0 0 1 1 0 1 8 2 4 5
$EndEntities
$Nodes
2 6 1 9
0 1 0 1
1
0 0 0
2 3 0 5
2
9
3
4
5
1 0 0
0.25 0.5 0
1 1 0
0 1 0
0.5 5e-1 0
$EndNodes
$Elements
3 6 1 6
1 4 1 1
2 5 1
1 5 1 1
7 1 2
2 3 2 4
3 1 2 5
4 2 5 3
5 3 4 5
6 4 1 5
$EndElements
)";

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

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(MeshReader, TakesGroupsThatRunThroughACurveBackwards) {
  expect_square(parse_mesh(with(square_22, "2 1 2 7 1 5 1", "2 1 2 -7 1 5 1"), "a.msh"));
  const std::string turned = with(square_41, "4 0 0 0 1 1 0 1 7 2 1 -1", "4 0 0 0 1 1 0 1 -7 2 1 -1");
  expect_square(parse_mesh(turned, "a.msh"));
  const Assembly rock = parse_mesh(with(turned, "3 0 0 0 1 1 0 1 8 2 4 5", "3 0 0 0 1 1 0 1 -8 2 4 5"), "a.msh");
  EXPECT_THAT(rock.groups.at("the rock"), ElementsAre(0, 1, 2, 3));
}

TEST(MeshReader, RefusesACrackWithoutALine) {
  for (const std::string& text : {with(square_22, "2 1 2 7 1 5 1", "2 1 2 9 1 5 1"),
                                  with(square_41, "4 0 0 0 1 1 0 1 7 2 1 -1", "4 0 0 0 1 1 0 1 9 2 1 -1")}) {
    try {
      parse_mesh(text, "a.msh");
      FAIL() << "was read";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("a.msh: the physical group \"crack\" (tag 7) has no line of the mesh"));
    }
  }
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

struct Fault {
  std::string from, to, message;
};

TEST(MeshReader, SaysWhatIsWrongAndWhere) {
  const std::vector<Fault> faults{
      {"2.2 0 8", "2.2 1 8", "a.msh:2: a binary mesh"},
      {"2.2 0 8", "4 0 8", "a.msh:2: mesh format 4 "},
      {"$MeshFormat", "$Nodes", "a.msh:1: found '$Nodes', expected $MeshFormat"},
      {"1 1 0\n4 0 1 0", "1 nan 0\n4 0 1 0", "a.msh:17: found 'nan', expected a finite number"},
      {"$Nodes\n6", "$Nodes\n-6", "a.msh:13: a count of -6"},
      {"$Nodes\n6", "$Nodes\n99999999999", "a.msh:13: a count of 99999999999"},
      {"$Nodes\n6", "$Nodes\n5", "a.msh:19: found '5', expected $EndNodes"},
      {"9 0.25", "1 0.25", "a.msh:16: node 1 is defined twice"},
      {"5 2 2 8 1 3 4 5", "5 2 2 8 1 3 4 77", "a.msh:27: node 77 is not defined"},
      {"5 2 2 8 1 3 4 5", "5 3 2 8 1 3 4 5 1", "a.msh:27: element type 3 is not supported"},
      {"5 2 2 8 1 3 4 5", "5 2 2 8 1 3 4 x", "a.msh:27: found 'x', expected a whole number"},
      {"$EndElements", "", "the file ends too early"},
      {"1 1 0\n4 0 1 0", "1 1 1\n4 0 1 0", "plane of constant z"},
      {"2 1 2 7 1 5 1", "2 1 2 7 1 1 2", "not an edge between two triangles"},
      {"5 0.5 5e-1", "5 0.5 1e-3", "smallest angle"},
      {"\"crack\"", "crack", "a.msh:9: expected a name in quotation marks"},
  };
  for (const auto& fault : faults) {
    auto text = square_22;
    const auto at = text.find(fault.from);
    ASSERT_NE(at, std::string::npos) << fault.from;
    text.replace(at, fault.from.size(), fault.to);
    try {
      parse_mesh(text, "a.msh");
      ADD_FAILURE() << fault.message << " accepted";
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr(fault.message));
    }
  }
}

TEST(MeshReader, EchoesNeitherEscapesNorMegabytes) {
  const std::string million(1000000, 'y');
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{"2.2 0 8", million},
                                                                                 {"$Nodes", million},
                                                                                 {"$EndNodes", "\x1b[2J" + million},
                                                                                 {"1 1 0\n4", "\x9b" + million}}) {
    auto text = square_22;
    text.replace(text.find(from), from.size(), to);
    try {
      parse_mesh(text, "a.msh");
      ADD_FAILURE() << from << " accepted";
    } catch (const InputError& e) {
      const std::string message = e.what();
      EXPECT_LT(message.size(), 200u);
      EXPECT_EQ(message.find_first_of("\x1b\x9b"), std::string::npos);
    }
  }
}

// Any damage is either noticed or harmless: nothing but InputError leaves the reader.
TEST(MeshReader, SurvivesRandomDamage) {
  std::mt19937 random(1);
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    auto text = i % 2 == 0 ? square_22 : square_41;
    for (int k = 0; k < 1 + i % 3; ++k) text[random() % text.size()] = static_cast<char>(random() % 256);
    if (i % 5 == 0) text.resize(random() % text.size());
    try {
      parse_mesh(text, "a.msh");
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 2000);
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
