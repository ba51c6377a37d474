// Pathways as wide as their cracks gape, below the size of a cell and above.
#include "base/require.hpp"
#include "dem_support.hpp"
#include "support/coupled_run.hpp"
#include "support/cracked_rock.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::cracked_rock;

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
