// Minerals of one rock: the balance of each, where pixels vanish and where pathways hand solid on, and their triangles.
#include "base/require.hpp"
#include "support/coupled_run.hpp"
#include "support/minerals_of_small_rock.hpp"
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

/// A round grain of two halves around an inert core, which dissolves until pixels are gone everywhere.
const std::string grain = R"(
[lattice]
size = [0.006, 0.006]
spacing = 1e-4
time_step = 1e-5
[time]
steps = 1000000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "disc"
centre = [0.003, 0.003]
radius = 0.0018
[solute]
[[solute.species]]
name = "acid"
diffusivity = 2e-4
initial = 1000
[[solute.species]]
name = "salt"
diffusivity = 1e-4
[reaction]
reactant = "acid"
product = "salt"
rate_constant = 0.5
equilibrium_constant = 20
molar_volume = 2e-4
[boundary.left]
solute = { type = "concentration", concentration = { acid = 1000 } }
[boundary.right]
solute = { type = "concentration", concentration = { acid = 1000 } }
)";
const std::string halves = R"(
[[mineral]]
name = "upper"
rate_constant = 0.1
molar_volume = 3e-4
order = 0.7
equilibrium_constant = inf
[[mineral.shapes]]
type = "rectangle"
from = [0, 0.003]
to = [0.006, 0.006]
[[mineral]]
name = "core"
inert = true
[[mineral.shapes]]
type = "disc"
centre = [0.003, 0.003]
radius = 0.001
)";

TEST(MineralLedger, OfEachClosesToRoundOffWhilePixelsVanish) {
  for (const std::string precision : {"double", "single"}) {
    test::CoupledRun run(grain + halves, {"accuracy.precision=\"" + precision + "\""});
    run.steps(6000);
    EXPECT_GT(run.now("nodes_dissolved_1"), 100);
    double stored = 0, dissolved = 0, overdrawn = 0;
    for (const char* name : {"rock", "upper", "core"}) {
      stored += run.now(std::string(name) + "_volume_stored_m3_per_m");
      dissolved += run.gain(std::string(name) + "_volume", "dissolved");
      overdrawn += run.gain(std::string(name) + "_volume", "overdrawn");
      EXPECT_LT(std::abs(run.now(std::string(name) + "_volume_balance_error_1")), 1e-13) << name;
    }
    EXPECT_NEAR(stored / run.now("solid_volume_stored_m3_per_m"), 1, 1e-13);
    EXPECT_NEAR(dissolved / run.gain("solid_volume", "dissolved"), 1, 1e-13);
    EXPECT_NEAR(overdrawn, run.gain("solid_volume", "overdrawn"), 1e-13 * std::abs(dissolved));
    EXPECT_LT(std::abs(run.now("upper_dissolved_balance_error_1")), 1e-12);
    EXPECT_LT(std::abs(run.now("rock_dissolved_balance_error_1")), 1e-12);
    // the amounts that the minerals have taken are what the fluid has lost
    const double acid = run.gain("rock_dissolved", "by_acid") + run.gain("upper_dissolved", "by_acid");
    EXPECT_NEAR(acid / -run.gain("acid", "reaction"), 1, 1e-12);
    EXPECT_LT(run.worst_balance(), precision == "double" ? 1e-12 : 1e-4);
  }
}

/// A material of a mineral is that of its shapes but where a later mineral lies, and triangles follow their outlines.
TEST(MineralRock, GivesTrianglesTheirMaterial) {
  const std::string rock = R"(
[lattice]
size = [0.02, 0.02]
spacing = 1e-3
time_step = 1e-5
[time]
steps = 10
[geometry]
type = "rock"
[rock]
element_size = 2e-3
[heat]
fluid_diffusivity = 1e-4
solid_diffusivity = 1e-4
[boundary.left]
traction = { support = "roller" }
[boundary.bottom]
traction = { support = "roller" }
[mechanics]
preload_time = 1e-6
)";
  const std::string by_form = R"(
[[mechanics.material]]
type = "rectangle"
from = [0.0, 0.0]
to = [0.02, 0.01]
young_modulus = 4e10
[[mechanics.material]]
type = "disc"
centre = [0.01, 0.01]
radius = 0.004
)";
  const std::string minerals = R"(
[[mineral]]
name = "lower"
[[mineral.shapes]]
type = "rectangle"
from = [0.0, 0.0]
to = [0.02, 0.01]
[[mineral]]
name = "grain"
[[mineral.shapes]]
type = "disc"
centre = [0.01, 0.01]
radius = 0.004
)";
  const std::string by_mineral =
      "[[mechanics.material]]\ntype = \"mineral\"\nmineral = \"lower\"\nyoung_modulus = 4e10\n"
      "[[mechanics.material]]\ntype = \"mineral\"\nmineral = \"grain\"\n";
  const test::CoupledRun form(rock + by_form), mineral(rock + minerals + by_mineral);
  const Assembly &a = form.parts().rock->assembly, &b = mineral.parts().rock->assembly;
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.region, b.region);
  for (const int material : {0, 1, 2})
    EXPECT_GT(std::count(b.region.begin(), b.region.end(), material), 10) << material;
  // the later mineral has taken its triangles out of the earlier one, whether it has a material or not
  const std::string lower = by_mineral.substr(0, by_mineral.rfind("[[mechanics.material]]"));
  const test::CoupledRun one(rock + minerals + lower);
  const Assembly& c = one.parts().rock->assembly;
  for (std::size_t t = 0; t < c.region.size(); ++t) {
    std::array<double, 2> centroid{0, 0};
    for (const int v : c.triangles[t])
      for (int axis = 0; axis < 2; ++axis) centroid[axis] += c.vertices[v][axis] / 3;
    const bool inside = std::hypot(centroid[0] - 0.01, centroid[1] - 0.01) < 0.004;
    EXPECT_EQ(c.region[t], !inside && centroid[1] < 0.01 ? 1 : 0) << t;
  }
  const std::vector<double> numbers = mineral.nodes("mineral");
  EXPECT_EQ(numbers[9 * 20 + 9], 2);
  EXPECT_EQ(numbers[2 * 20 + 2], 1);
  EXPECT_EQ(numbers[18 * 20 + 2], 0);
}

TEST(MineralRock, MayBeAGroupOfAMesh) {
  const test::CoupledRun run(read_scene(VUG_SOURCE_DIR "/tests/cases/complete/mesh.toml"));
  const std::vector<double> mineral = run.nodes("mineral"), type = run.nodes("node_type");
  EXPECT_GT(std::count(mineral.begin(), mineral.end(), 1), 50);
  for (std::size_t n = 0; n < mineral.size(); ++n) EXPECT_EQ(mineral[n], type[n] == 1 ? 1 : -1) << n;
}

TEST(MineralRock, IsRefusedWhereNoNodeIsLeftToAMineral) {
  const std::string over =
      "[[mineral]]\nname = \"over\"\n[[mineral.shapes]]\ntype = \"rectangle\"\nfrom = [0, 0]\n"
      "to = [0.006, 0.006]\n";
  const std::string in_fluid =
      "[[mineral]]\nname = \"wet\"\n[[mineral.shapes]]\ntype = \"disc\"\n"
      "centre = [0.0005, 0.0005]\nradius = 0.0003\n";
  EXPECT_THROW(test::CoupledRun run(grain + halves + over), InputError);
  EXPECT_THROW(test::CoupledRun run(grain + in_fluid), InputError);
}

/// Pathways that damage opens hand their solid on, within each mineral.
TEST(MineralLedger, OfEachClosesWherePathwaysOpen) {
  std::vector<std::string> choices = test::minerals_of_small_rock();
  choices.emplace_back("reaction.rate_constant=30");
  test::CoupledRun run(test::contents(test::small_rock), choices);
  run.steps(400);
  EXPECT_GT(run.now("nodes_dissolved_1"), 10);
  EXPECT_GT(run.now("nodes_opened_by_damage_1"), 100);
  double stored = 0, waiting = 0;
  for (const std::string name : {"rock", "calcite", "dolomite", "quartz"}) {
    stored += run.now(name + "_volume_stored_m3_per_m");
    waiting += run.gain(name + "_volume", "waiting");
    EXPECT_LT(std::abs(run.now(name + "_volume_balance_error_1")), 1e-13) << name;
    if (name == "quartz") continue;
    EXPECT_LT(std::abs(run.now(name + "_dissolved_balance_error_1")), 1e-12) << name;
  }
  EXPECT_NEAR(stored / run.now("solid_volume_stored_m3_per_m"), 1, 1e-13);
  EXPECT_NEAR(waiting, run.gain("solid_volume", "waiting"), 1e-13 * stored);
  EXPECT_EQ(run.gain("quartz_volume", "dissolved"), 0);
  EXPECT_LT(run.worst_balance(), 1e-11);
}

/// A mineral that is the rock under another name.
TEST(MineralLedger, ARockThatIsCalledAMineralDoesTheSame) {
  const std::string all =
      "[[mineral]]\nname = \"all\"\n[[mineral.shapes]]\ntype = \"rectangle\"\nfrom = [0, 0]\n"
      "to = [0.006, 0.006]\n";
  for (const std::string wall : {"kinetic", "paper"}) {
    const std::vector<std::string> choices{"reaction.wall=\"" + wall + "\"", "reaction.activation_energy=20000"};
    test::CoupledRun plain(grain, choices), named(grain + all, choices);
    plain.steps(3000);
    named.steps(3000);
    EXPECT_GT(plain.now("nodes_dissolved_1"), 20);
    for (const char* field : {"concentration_acid", "concentration_salt", "dissolved_fraction", "solid_fraction"}) {
      const std::vector<double> a = plain.nodes(field), b = named.nodes(field);
      for (std::size_t n = 0; n < a.size(); ++n) ASSERT_NEAR(a[n], b[n], 1e-10 * (1 + std::abs(a[n]))) << field << n;
    }
    EXPECT_NEAR(plain.now("acid_gain_reaction_mol_per_m") / named.now("acid_gain_reaction_mol_per_m"), 1, 1e-12);
  }
}

}  // namespace
}  // namespace vug
