// What is given at sides and shapes flows through them, in SI: rates, tables over time and along a side, fluxes.
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"
#include "verification/surface_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using namespace test::surfaces;

/// A parabola of mean U lets in U times the height exactly; its concentration leaves as it came.
TEST(Flows, OfMassAndSpeciesThroughAChannel) {
  constexpr int nx = 24, ny = 8;
  test::CoupledRun run(
      lattice(nx, ny) + flow + told +
      "[[solute.species]]\nname = \"A\"\ndiffusivity = 4e-4\n"
      "[boundary.left]\nflow = { type = \"velocity\", velocity = [0.05, 0], profile = \"parabolic\" }\n"
      "solute = { type = \"concentration\", concentration = { A = 30 } }\n"
      "[boundary.right]\nflow = { type = \"outflow\" }\nsolute = { type = \"outflow\" }\n");
  run.steps(6000);
  const double volume = 0.05 * ny * dx;  // m2/s
  EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s"), density * volume, 1e-9 * density * volume);
  EXPECT_NEAR(run.now("right_mass_flow_kg_per_m_s"), -density * volume, 1e-6 * density * volume);
  EXPECT_NEAR(run.now("left_A_flow_mol_per_m_s"), 30 * volume, 1e-3 * 30 * volume);
  EXPECT_NEAR(run.now("right_A_flow_mol_per_m_s"), -30 * volume, 1e-3 * 30 * volume);
  EXPECT_NEAR(run.now("right_A_mean_mol_per_m3"), 30, 0.03);
  // the nodes' speeds are those of the parabola and add up to the rate; midpoints of a parabola have 1/(2 n^2) more
  const std::vector<double> velocity = run.nodes("velocity");
  for (int y = 0; y < ny; ++y) {
    const double s = (y + 0.5) / ny;
    EXPECT_NEAR(velocity[2 * (y * nx + nx / 2)], 0.05 * 6 * s * (1 - s) / (1 + 0.5 / (ny * ny)), 1e-6);
  }
}

/// A rate is a rate whatever part of the side the fluid has, also out of a shape.
TEST(Flows, GivenAsRatesEnterExactly) {
  constexpr int nx = 20, ny = 12;
  const std::string rock = "[geometry]\ntype = \"shapes\"\n" + test::rectangle(0, 0, nx * dx, 3 * dx);
  for (const std::string given : {"flow_rate = 3e-4", "mass_flow_rate = 0.24", "flow_rate = [[0, 3e-4], [1, 3e-4]]",
                                  "flow_rate = 3e-4, profile = \"parabolic\""}) {
    test::CoupledRun run(lattice(nx, ny) + rock + flow + told + "[boundary.left]\nflow = { type = \"velocity\", " +
                         given + " }\n[boundary.right]\nflow = { type = \"outflow\" }\n");
    run.steps(10);
    EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s"), 0.24, 1e-12) << given;
  }
  test::CoupledRun well(lattice(nx, ny) + flow + told + test::disc(9 * dx, 6 * dx, 2.7 * dx, "name = \"post\"") +
                        "[boundary.shape.post]\nflow = { type = \"velocity\", flow_rate = 3e-4 }\n"
                        "[boundary.right]\nflow = { type = \"outflow\" }\n");
  well.steps(10);
  EXPECT_NEAR(well.now("shape_post_mass_flow_kg_per_m_s"), 0.24, 1e-12);
}

/// Linear between the points, constant outside; a table of the velocity along the side.
TEST(Flows, FollowTablesOverTimeAndAlongTheSide) {
  constexpr int nx = 12, ny = 10;
  const auto run_with = [&](const std::string& condition) {
    return test::CoupledRun(lattice(nx, ny) + flow + told + "[boundary.left]\nflow = { type = \"velocity\", " +
                            condition + " }\n[boundary.right]\nflow = { type = \"outflow\" }\n");
  };
  test::CoupledRun run = run_with("velocity = [[0.010, 0, 0], [0.030, 0.05, 0], [\"40 ms\", 0.02, 0]]");
  const double full = density * ny * dx;
  const auto expect = [&](int step, double velocity) {
    run.steps(step - static_cast<int>(run.now("step_1")));
    EXPECT_NEAR(run.now("left_mass_flow_kg_per_m_s"), full * velocity, 1e-10) << step;
  };
  expect(5, 0);
  expect(15, 0.0125);
  expect(35, 0.035);
  expect(100, 0.02);
  test::CoupledRun ramp = run_with("velocity = [0.05, 0], ramp_time = 0.02");
  ramp.steps(5);
  EXPECT_NEAR(ramp.now("left_mass_flow_kg_per_m_s"), full * 0.0125, 1e-10);
  test::CoupledRun half = run_with("velocity = [0.05, 0], profile = \"table\", profile_table = [[0, 0], [0.020, 1]]");
  half.steps(5);
  EXPECT_NEAR(half.now("left_mass_flow_kg_per_m_s"), full * 0.025, 1e-10);
}

TEST(Flows, OfHeatAndSpeciesFollowTablesOverTime) {
  constexpr int nx = 12, ny = 10;
  test::CoupledRun run(
      lattice(nx, ny) + flow + heat + told +
      "[[solute.species]]\nname = \"A\"\ndiffusivity = 4e-4\n"
      "[boundary.left]\nheat = { type = \"flux\", flux = [[0, 0], [0.1, 1e5]] }\n"
      "solute = { type = \"concentration\", concentration = { A = [[0.05, 10], [0.06, 20]] } }\n"
      "[boundary.bottom]\nheat = { type = \"temperature\", temperature = [[0.0, 350], [0.1, 400]] }\n");
  run.steps(50);
  EXPECT_NEAR(run.now("left_heat_flow_W_per_m"), 0.5e5 * ny * dx, 1e-6);
  run.steps(30000);
  for (const double value : run.nodes("concentration_A")) EXPECT_NEAR(value, 20, 1e-6);
}

/// mol/(cm2 s) through a slab: the gradient is flux over diffusivity, and what enters is the flux times the area.
TEST(Flows, OfAGivenFluxOfSpecies) {
  constexpr int nx = 12, ny = 10;
  for (const std::string set : {"d2q5", "d2q9"}) {
    test::CoupledRun run(lattice(nx, ny) + told +
                             "[[solute.species]]\nname = \"A\"\ndiffusivity = \"4 cm2/s\"\ninitial = \"1e-5 mol/cm3\"\n"
                             "[boundary.left]\nsolute = { type = \"flux\", flux = { A = \"2e-6 mol/(cm2 s)\" } }\n"
                             "[boundary.right]\nsolute = { type = \"concentration\", concentration = { A = 10 } }\n",
                         {"solute.velocity_set=" + set});
    run.steps(20000);
    EXPECT_NEAR(run.now("left_A_flow_mol_per_m_s"), 2e-2 * ny * dx, 1e-12) << set;
    EXPECT_NEAR(run.now("right_A_flow_mol_per_m_s"), -2e-2 * ny * dx, 1e-10) << set;
    const std::vector<double> acid = run.nodes("concentration_A");
    const double tolerance = set == "d2q5" ? 1e-6 : 0.025;  // its walls turn back what moves diagonally along them
    for (int x = 1; x < nx - 1; ++x)
      EXPECT_NEAR(acid[ny / 2 * nx + x], 10 + 2e-2 / 4e-4 * (nx - x - 0.5) * dx, tolerance) << set;
  }
  test::CoupledRun post(lattice(nx, ny) + told + test::disc(6 * dx, 5 * dx, 2.2 * dx, "name = \"post\"") +
                        "[[solute.species]]\nname = \"A\"\ndiffusivity = 4e-4\n"
                        "[boundary.shape.post]\nsolute = { type = \"flux\", flux = { A = [[0, 0], [0.01, 2e-2]] } }\n");
  post.steps(20);
  const double circumference = 2 * std::acos(-1.0) * 2.2 * dx;
  EXPECT_NEAR(post.now("shape_post_A_flow_mol_per_m_s"), 2e-2 * circumference, 1e-9 * 2e-2 * circumference);
}

}  // namespace
}  // namespace vug
