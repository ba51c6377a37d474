// A rock of more than a hundred thousand triangles: generated, written as a mesh and read, loaded, broken.
#include "dem/soundness.hpp"
#include "io/mesh_reader.hpp"
#include "support/specimens.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace vug;
using namespace vug::test;

/// A Gmsh file of version 2.2, to a hundredth of a micrometre.
std::string gmsh_text(const Assembly& assembly) {
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(assembly.vertices.size()) + "\n";
  for (std::size_t i = 0; i < assembly.vertices.size(); ++i) {
    char line[80];
    std::snprintf(line, sizeof line, "%zu %.8f %.8f 0\n", i + 1, assembly.vertices[i][0], assembly.vertices[i][1]);
    text += line;
  }
  text += "$EndNodes\n$Elements\n" + std::to_string(assembly.triangles.size()) + "\n";
  for (std::size_t k = 0; k < assembly.triangles.size(); ++k) {
    const auto& [a, b, c] = assembly.triangles[k];
    char line[80];
    std::snprintf(line, sizeof line, "%zu 2 2 1 1 %d %d %d\n", k + 1, a + 1, b + 1, c + 1);
    text += line;
  }
  return text + "$EndElements\n";
}

TEST(LargeRockLong, CarriesAWaveAtItsImpedanceAndBreaks) {
  const double width = 0.1, height = 0.07;
  const Assembly generated = generate_rock(width, height, elements(3.8e-4));
  ASSERT_GE(generated.triangles.size(), 100000u);
  const Assembly rock_read = parse_mesh(gmsh_text(generated), "large.msh");
  ASSERT_EQ(rock_read.triangles, generated.triangles);

  Loads loads;
  loads.support = {Support::roller, Support::roller, Support::roller, Support::roller};
  const double gentle = 0.1;
  loads.velocity[static_cast<std::size_t>(RockSide::top)] = {0, -gentle};
  Mechanics rock(rock_read, {}, loads);
  const Exec exec;
  const double dt = 0.3 * rock.critical_step();
  double stress = 0;
  for (int k = 0; k < 10; ++k) {
    rock.advance(exec, dt, 100);
    if (k >= 5) stress += -rock.reaction(RockSide::top).y / width / 5;
  }
  // a platen of speed v in rock whose sides are held: rho c v with c = sqrt(E / (1 - nu^2) / rho), E and nu of the
  // paper
  const double modulus = 27.8e9 / (1 - 0.24 * 0.24);
  const double expected = std::sqrt(modulus * 2500) * gentle;
  record("large_rock",
         {{"triangles", static_cast<double>(rock_read.triangles.size())}, {"stress", stress}, {"expected", expected}});
  EXPECT_NEAR(stress, expected, 0.02 * expected);
  EXPECT_EQ(rock.bond_counts().failed(), 0);

  rock.set_platen_velocity(RockSide::top, {0, -30});  // 250 MPa
  rock.advance(exec, dt, 1000);
  require_sound(exec, rock);
  EXPECT_GT(rock.bond_counts().failed(), 10);
}

}  // namespace
