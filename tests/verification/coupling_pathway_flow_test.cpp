// Damage to pathway to flow: what passes through a crack grows with the cube of its aperture.
#include "dem_support.hpp"
#include "support/coupled_run.hpp"
#include "support/cracked_rock.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

namespace vug {
namespace {

using test::cracked_rock;

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

/// The aperture of a bond that has failed is c_d times the distance of the centroids on its sides; with "added", so
/// much more than the one cell of its notch.
TEST(CrackedBond, OpensToTheShareOfTheCentroidsDistanceThatTheCaseGives) {
  for (const auto& [factor, widening, notch] :
       {std::tuple{0.3, "largest", 0}, {0.6, "largest", 0}, {0.3, "added", 1}, {0.6, "added", 1}}) {
    test::CoupledRun run(cracked_rock, {"damage.minimum_aperture=1", "damage.pathway_factor=" + std::to_string(factor),
                                        std::string("damage.pathway_widening=") + widening});
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
      const double aperture = notch + factor * spacing(k) / 2.5e-4;
      EXPECT_NEAR(open, aperture, 1) << "bond " << k;
      if (aperture > std::floor(aperture) + 0.15) {
        EXPECT_EQ(open, std::ceil(aperture)) << "bond " << k;  // in its middle
      }
      ++failed;
    }
    EXPECT_GE(failed, 4);
  }
}

}  // namespace
}  // namespace vug
