// Gmsh meshes that cannot be read: what is wrong is said with its line.
#include "base/require.hpp"
#include "io/mesh_reader.hpp"
#include "unit/square_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

using test::square_22;
using test::square_41;
using test::with;
using ::testing::HasSubstr;

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

}  // namespace
}  // namespace vug
