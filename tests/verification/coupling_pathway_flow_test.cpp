// Damage to pathway to flow: what passes through a crack grows with the cube of its aperture.
#include "dem_support.hpp"
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

}  // namespace
}  // namespace vug
