// The mean concentration at a surface where it differs from place to place.
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

#include <string>

namespace vug {
namespace {

/// What leaves with the flow is the mean times the flow; acid that the walls take is densest where it flows fastest.
TEST(SurfaceMeans, AreOfWhatLeavesWithTheFlow) {
  test::CoupledRun run(
      test::unit_lattice(30, 10) +
      "[flow]\nviscosity = 0.2\ninitial_pressure = 0\ndensity = 800\n[output]\nflows = true\n"
      "[[solute.species]]\nname = \"A\"\ndiffusivity = 0.03\n"
      "[boundary.left]\nflow = { type = \"velocity\", velocity = [0.03, 0], profile = \"parabolic\" }\n"
      "solute = { type = \"concentration\", concentration = { A = 30 } }\n"
      "[boundary.bottom]\nsolute = { type = \"concentration\", concentration = { A = 0 } }\n"
      "[boundary.top]\nsolute = { type = \"concentration\", concentration = { A = 0 } }\n"
      "[boundary.right]\nflow = { type = \"outflow\" }\nsolute = { type = \"outflow\" }\n");
  run.steps(6000);
  const double mixed = run.now("right_A_flow_mol_per_m_s") / (run.now("right_mass_flow_kg_per_m_s") / 800);
  EXPECT_NEAR(run.now("right_A_mean_mol_per_m3"), mixed, 0.02 * mixed);  // some diffuses as well
  double plain = 0;
  for (int y = 0; y < 10; ++y) plain += run.nodes("concentration_A")[y * 30 + 29] / 10;
  EXPECT_GT(mixed, 1.1 * plain);  // so that the two are told apart
}

/// Nothing flows: all places count alike. Acid that diffuses from left to right falls in a straight line.
TEST(SurfaceMeans, ArePlainWhereNothingFlows) {
  test::CoupledRun run(test::unit_lattice(12, 6) +
                       "[output]\nflows = true\n[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\n"
                       "[boundary.left.solute]\ntype = \"concentration\"\nconcentration = { A = 30 }\n"
                       "[boundary.right.solute]\ntype = \"concentration\"\nconcentration = { A = 6 }\n"
                       "[boundary.top.solute]\ntype = \"flux\"\nflux = { A = 0 }\n");
  run.steps(10000);
  EXPECT_NEAR(run.now("left_A_mean_mol_per_m3"), 29, 1e-6);  // half a cell from the side
  EXPECT_NEAR(run.now("top_A_mean_mol_per_m3"), 18, 1e-6);
}

}  // namespace
}  // namespace vug
