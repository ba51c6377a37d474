// Damage to pathway to flow: what passes through a crack grows with the cube of its aperture.
#include "dem_support.hpp"
#include "kernels/base/require.hpp"
#include "support/coupled_run.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vug {
namespace {

/// Rock of 80 x 41 cells, cracked from the left to the right along the middle of row 20; 1 kPa drives water through.
const std::string cracked_rock = R"(
[lattice]
size = [0.02, 0.01025]
spacing = 2.5e-4
time_step = 2.5e-6
[time]
steps = 100000
[geometry]
type = "rock"
[rock]
element_size = 4e-3
porosity = 0
[[rock.notches]]
from = [0, 5.125e-3]
to = [0.02, 5.125e-3]
aperture = 1
[flow]
viscosity = 2.2e-3
initial_pressure = 100e3
[mechanics]
[damage]
pathway_factor = 1e-6
[boundary.left]
flow = { type = "pressure", pressure = 101e3 }
traction = { support = "fixed" }
[boundary.right]
flow = { type = "pressure", pressure = 100e3 }
traction = { support = "fixed" }
)";

/// Also where the crack lies on the boundary between two rows.
TEST(CrackedBond, ConductsWithTheCubeOfItsAperture) {
  const double dx = 2.5e-4, viscosity = 1000 * 2.2e-3;
  for (const auto& [aperture, row] : {std::pair{3, 20.5}, {5, 20.5}, {9, 20.5}, {3, 20.0}}) {
    const std::string line = std::to_string(row * dx);
    test::CoupledRun run(
        cracked_rock, {"damage.minimum_aperture=" + std::to_string(aperture), "rock.notches.0.from=[0, " + line + "]",
                       "rock.notches.0.to=[0.02, " + line + "]"});
    run.steps(14 * aperture * aperture + 4000);
    const auto pressure = run.nodes("pressure"), velocity = run.nodes("velocity");
    const auto at = [](int x, int y) { return static_cast<std::size_t>(y * 80 + x); };
    double flow = 0;  // m2/s, through the middle of the crack
    int open = 0;
    for (int y = 0; y < 41; ++y) {
      const double u = velocity[2 * at(40, y)];
      if (u == 0 || std::isnan(u)) continue;
      flow += u * dx;
      ++open;
    }
    EXPECT_EQ(open, aperture);
    const double gradient = (pressure[at(30, 20)] - pressure[at(50, 20)]) / (20 * dx);
    const double cubic_law = std::pow(aperture * dx, 3) * gradient / (12 * viscosity);
    // every node lies on the parabola; their sum, which is what flows, is larger than its integral by the share
    // 1/(2 n^2) (midpoint rule): 5.6 % where a crack has three nodes
    const double midpoint_rule = 1 + 1 / (2.0 * aperture * aperture);
    EXPECT_GT(gradient, 0.5 * 1000 / 0.02);
    // what is left of the start (1e-6 after 12000)
    EXPECT_NEAR(flow / (midpoint_rule * cubic_law), 1, 1e-4) << aperture << " at " << row;
    if (row != 20.5) continue;
    test::record("coupling_cubic_law",
                 {{"nodes", aperture}, {"flow", flow / gradient}, {"exact", cubic_law / gradient}});
  }
}

/// Flow rate over pressure gradient and density of `cracked_rock`, m4 s/kg: what passes the middle of the crack.
double conductance(test::CoupledRun& run) {
  const auto pressure = run.nodes("pressure"), velocity = run.nodes("velocity");
  const auto at = [](int x, int y) { return static_cast<std::size_t>(y * 80 + x); };
  double flow = 0;
  for (int y = 0; y < 41; ++y) {
    const double u = velocity[2 * at(40, y)];
    if (!std::isnan(u)) flow += u * 2.5e-4;
  }
  const double gradient = (pressure[at(30, 20)] - pressure[at(50, 20)]) / (20 * 2.5e-4);
  EXPECT_GT(gradient, 0.3 * 1000 / 0.02);
  return flow / gradient;
}

/// Widths in metres, less than a cell and more: the last two are those of two and three whole rows.
TEST(CrackedBond, ConductsByTheCubicLawHoweverManyCellsItsWidthIs) {
  std::string rock = cracked_rock;
  rock.replace(rock.find("aperture = 1"), 12, "width = 1e-4");
  rock.replace(rock.find("porosity = 0"), 12, "porosity = 0\npathway_width = 1e-4");
  for (const double cells : {0.6, 0.8, 1.1, std::cbrt(9.0), std::cbrt(28.5)}) {
    const double width = cells * 2.5e-4;
    test::CoupledRun run(rock, {"rock.notches.0.width=" + std::to_string(width), "damage.minimum_width=1e-5"});
    run.steps(cells < 1 ? 20000 : 5000);
    const double cubic_law = std::pow(width, 3) / (12 * 1000 * 2.2e-3);
    EXPECT_NEAR(conductance(run) / cubic_law, 1, 0.02) << cells;
    test::record("coupling_width_in_metres",
                 {{"cells", cells}, {"conductance", conductance(run)}, {"exact", cubic_law}});
  }
}

/// What diffuses along a slit of w cells from C = 1 beyond its left end to 0 beyond the right one meets half a cell of
/// the whole D, n - 1 links of w D, and half a cell again.
TEST(CrackedBond, LetsSolutesDiffuseByItsWidth) {
  constexpr int n = 20;
  std::string rock = cracked_rock;
  rock.replace(rock.find("aperture = 1"), 12, "width = 1e-4");
  rock.replace(rock.find("porosity = 0"), 12, "porosity = 0\npathway_width = 1e-4");
  rock.replace(rock.find("101e3"), 5, "100e3");
  rock.replace(rock.find("[boundary.left]\n"), 16,
               "[boundary.left]\nsolute = { type = \"concentration\", concentration = { A = 1 } }\n");
  rock.replace(rock.find("[boundary.right]\n"), 17,
               "[boundary.right]\nsolute = { type = \"concentration\", concentration = { A = 0 } }\n");
  rock += "[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = 1.25e-2\n";  // 0.5 in lattice units
  for (const double cells : {0.1, 0.6}) {
    const std::string width = std::to_string(cells * 2.5e-4);
    test::CoupledRun run(
        rock, {"lattice.size=[0.005, 0.01025]", "rock.element_size=2.4e-3", "rock.notches.0.width=" + width,
               "rock.notches.0.to=[0.005, 5.125e-3]", "rock.pathway_width=" + width, "damage.minimum_width=1e-5"});
    run.steps(static_cast<int>(1000 / cells));
    const auto C = run.nodes("concentration_A");
    const double first = C[20 * n], last = C[20 * n + n - 1];
    EXPECT_NEAR((1 - first) / (first - last) / (cells / (2 * (n - 1))), 1, 0.01) << cells;
    EXPECT_LT(run.worst_balance(), 1e-12);
  }
}

/// Rock has as little of its volume in pathways as their widths say, on every lattice: a straight one along a row, and
/// the joints between blocks in all directions (they overlap where they meet).
TEST(CrackedBond, TakesOnlyItsWidthOfTheRock) {
  std::string rock = cracked_rock;
  rock.replace(rock.find("aperture = 1"), 12, "width = 1e-4");
  rock.replace(rock.find("porosity = 0"), 12, "porosity = 0\npathway_width = 1e-4");
  rock +=
      "[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = 1e-3\n[reaction]\nreactant = \"A\"\n"
      "rate_constant = 1e-6\nmolar_volume = 1e-5\n";
  const auto cells_of_rock = [&](std::vector<std::string> settings) {
    settings.insert(settings.end(), {"damage.minimum_width=1e-5", "rock.pathway_width=1e-4"});
    test::CoupledRun run(rock, settings);
    EXPECT_LT(run.worst_balance(), 1e-14);
    const double spacing = run.parts().geometry.spacing;  // what finds no room is rock as well
    return sum_in_order(run.parts().geometry.volume) - run.gain("solid_volume", "waiting") / (spacing * spacing);
  };
  for (const double cells : {0.1, 0.6, 1.0})
    EXPECT_NEAR(cells_of_rock({"rock.notches.0.width=" + std::to_string(cells * 2.5e-4)}), 80 * (41 - cells), 1e-9)
        << cells;
  for (const char* spacing : {"5e-4", "2.5e-4", "1.25e-4"}) {
    const double rows = 0.01 / std::stod(spacing);
    const std::string coarse = std::string("lattice.spacing=") + spacing;
    EXPECT_NEAR(cells_of_rock({"lattice.size=[0.02, 0.01]", coarse, "rock.notches=[]", "rock.element_size=2e-3",
                               "rock.porosity=0.1"}) /
                    (2 * rows * rows),
                0.9, 0.01)
        << spacing;
  }
}

/// The aperture of a bond that has failed is c_d times the distance of the centroids on its sides.
TEST(CrackedBond, OpensToTheShareOfTheCentroidsDistanceThatTheCaseGives) {
  for (const double factor : {0.3, 0.6}) {
    test::CoupledRun run(cracked_rock,
                         {"damage.minimum_aperture=1", "damage.pathway_factor=" + std::to_string(factor)});
    run.steps(20);
    const auto solid = run.nodes("solid_fraction");
    const Bonds& bonds = run.rock().bonds();
    const auto state = test::host_copy(bonds.state);
    const auto spacing = test::host_copy(bonds.spacing);
    const auto vertex = test::host_copy(bonds.vertex);
    const Assembly& assembly = run.parts().rock->assembly;
    int failed = 0;
    for (int k = 0; k < bonds.count; ++k) {
      if (!has_failed(state(k))) continue;
      const double middle = (assembly.vertices[vertex(k, 0)][0] + assembly.vertices[vertex(k, 1)][0]) / 2;
      int open = 0;
      for (int y = 0; y < 41; ++y) open += solid[static_cast<std::size_t>(y * 80 + int(middle / 2.5e-4))] == 0;
      const double aperture = factor * spacing(k) / 2.5e-4;
      EXPECT_NEAR(open, aperture, 1) << "bond " << k;
      if (aperture > std::floor(aperture) + 0.15) {
        EXPECT_EQ(open, std::ceil(aperture)) << "bond " << k;  // in its middle
      }
      ++failed;
    }
    EXPECT_GE(failed, 4);
  }
}

/// The rock's lower half is held, its upper half is lifted by `gap` cells within 500 steps and held there: a slot,
/// narrower than a cell or wider, that water flows through. `pathway`: a line of [rock], in place of the notch's own
/// width.
test::CoupledRun lifted_rock(double gap, std::vector<std::string> more = {}, const std::string& pathway = "") {
  const double speed = gap * 2.5e-4 / 1.25e-3;
  std::vector<std::string> settings{"damage.pathway_factor=0.2",
                                    "damage.aperture=\"opening\"",
                                    "rock.hole={ from = [0, 3.125e-3], to = [4e-3, 7.125e-3] }",
                                    "rock.notches.0.from=[4e-3, 5.125e-3]",  // where there is water at the start
                                    "boundary.bottom.traction={ support = \"fixed\" }",
                                    "boundary.left.traction={}",
                                    "boundary.right.traction={}",
                                    "boundary.top.traction={ support = \"fixed\", velocity = [[0, 0, " +
                                        std::to_string(speed) + "], [1.25e-3, 0, " + std::to_string(speed) +
                                        "], [1.2525e-3, 0, 0]] }"};
  settings.insert(settings.end(), more.begin(), more.end());
  std::string text = cracked_rock;
  const std::string of_notch = "aperture = 1\n", of_all = "porosity = 0\n";
  text.replace(text.find(of_notch), of_notch.size(), pathway.empty() ? "aperture = 0\n" : "");
  text.replace(text.find(of_all), of_all.size(), of_all + pathway);
  return test::CoupledRun(text, settings);
}

/// Flow rate (m2/s) through the column between `first` and `last` over that of the plane slot of `gap` cells under the
/// pressures that row 20 has there. Mean of two steps: what drag holds back swings to and fro.
double over_cubic_law(test::CoupledRun& run, double gap, int first, int last) {
  const double dx = 2.5e-4, viscosity = 1000 * 2.2e-3;
  const auto at = [](int x, int y) { return static_cast<std::size_t>(y * 80 + x); };
  double flow = 0, gradient = 0;
  for (int step = 0; step < 2; ++step) {
    const auto pressure = run.nodes("pressure"), velocity = run.nodes("velocity");
    for (int y = 0; y < 41; ++y)
      if (const double u = velocity[2 * at((first + last) / 2, y)]; std::isfinite(u)) flow += u * dx;
    gradient += (pressure[at(first, 20)] - pressure[at(last, 20)]) / ((last - first) * dx);
    run.steps(1);
  }
  return flow / (std::pow(gap * dx, 3) * gradient / (12 * viscosity));
}

/// Wider than a cell the strip has columns of n and n + 1 nodes: over three of the four bonds, 16 columns each.
TEST(GapingCrack, ConductsByTheCubicLawBelowTheResolutionOfACell) {
  for (const double gap : {0.25, 0.5, 1.0, 1.6, 2.4}) {
    test::CoupledRun run = lifted_rock(gap);
    run.steps(3000);
    const double ratio = gap > 1 ? over_cubic_law(run, gap, 24, 72) : over_cubic_law(run, gap, 19, 21);
    EXPECT_NEAR(ratio, 1, gap <= 1 ? 0.01 : 0.05) << gap << " cells";
    test::record("gaping_crack", {{"gap", gap}, {"ratio", ratio}});
  }
}

/// A crack that gapes less conducts less again, down to what is left of it when its faces touch.
TEST(GapingCrack, ClosesAgain) {
  test::CoupledRun run =
      lifted_rock(0, {"damage.residual_aperture=1.25e-4",
                      "boundary.top.traction.velocity=[[0, 0, 0.2], [1.25e-3, 0, 0.2], "
                      "[1.2525e-3, 0, 0], [2.5e-3, 0, 0], [2.5025e-3, 0, -0.2], [3.7525e-3, 0, -0.2], "
                      "[3.755e-3, 0, 0]]"});
  run.steps(1000);
  EXPECT_NEAR(over_cubic_law(run, 1.5, 24, 72), 1, 0.15);
  run.steps(5000);
  EXPECT_NEAR(over_cubic_law(run, 0.5, 19, 21), 1, 0.05);
}

/// A pathway that is there from the start, with a width in metres, is widened by as much as its faces part.
TEST(GapingCrack, AddsToTheWidthThatAPathwayHas) {
  for (const double gap : {0.0, 0.25}) {
    test::CoupledRun run = lifted_rock(gap, {}, "pathway_width = 6.25e-5\n");
    run.steps(3000);
    EXPECT_NEAR(over_cubic_law(run, 0.25 + gap, 19, 21), 1, 0.01) << gap << " cells";
  }
}

/// Pressure enters a slit of 0.1 cells in some 1e5 steps, and changes by next to nothing from look to look meanwhile;
/// in a channel of three cells the flow is soon steady.
TEST(GapingCrack, KeepsTheFlowFromBeingHeldWhileItFills) {
  for (const bool slit : {true, false}) {
    test::CoupledRun run =
        lifted_rock(0, {"accuracy.flow_tolerance=0.1"}, slit ? "pathway_width = 2.5e-5\n" : "pathway_width = 7.5e-4\n");
    for (int look = 0; look < 40; ++look) run.steps(100);
    EXPECT_EQ(run.now("flow_held_steps_1") > 0, !slit);
  }
}

/// What is narrower than any slit would close without a word; where d_m rules, slits are counted as well.
TEST(GapingCrack, HasAtLeastTheWidthOfTheNarrowestSlit) {
  const auto with = [](const std::string& pathway, const std::string& key) {
    return lifted_rock(0, {"damage.aperture=\"damage\"", "damage.pathway_factor=1e-6", key}, pathway);
  };
  const std::string least = "pathway_width = 2.5e-6\n", wide = "pathway_width = 2.5e-5\n";  // 0.01 and 0.1 cells
  test::CoupledRun run = with(least, "rock.notches.0.width=2.5e-6");
  run.steps(20);
  EXPECT_GT(run.now("slit_nodes_1"), 60);
  EXPECT_THROW(with("pathway_width = 2.4e-6\n", "case.name=a"), InputError);
  EXPECT_THROW(with(wide, "rock.notches.0.width=2.4e-6"), InputError);
  EXPECT_THROW(with(wide, "damage.minimum_width=2.4e-6"), InputError);
}

/// What passes through a slit loses its momentum to the rock. All that pushes the fluid is the pressure on the 16 cells
/// of the hole at the left side, 1 kPa above that of the right, around y = 20 cells; a cell's worth of it ends in the
/// slit.
TEST(GapingCrack, FluidDragsTheRockAlong) {
  test::CoupledRun run = lifted_rock(0.5);
  run.steps(3000);
  const Particles& particles = run.rock().particles();
  const auto centre = test::host_copy(particles.x0);
  double drag = 0, turning = 0;  // about the corner of the lattice
  for (int step = 0; step < 2; ++step) {
    const auto force = test::host_copy(particles.force);
    const auto torque = test::host_copy(particles.torque);
    for (std::size_t t = 0; t < force.extent(0); ++t) {
      drag += force(t, 0) / 2;
      turning += (centre(t, 0) * force(t, 1) - centre(t, 1) * force(t, 0) + torque(t)) / 2;
    }
    run.steps(1);
  }
  EXPECT_NEAR(drag / (1000 * 16 * 2.5e-4), 1, 0.002);
  EXPECT_NEAR(turning / (-drag * 20 * 2.5e-4), 1, 0.002);
}

}  // namespace
}  // namespace vug
