// The edges of the flow: what must survive, what is known to break, and that a guard sees it.
#include "support/unstable_flows.hpp"

#include <gtest/gtest.h>

namespace vug {
namespace {

using test::percolate;
using test::Percolation;
using test::shear_layer_survives;

TEST(ShearLayer, DefaultCollisionIsStableAtTheViscosityOfThePaper) {
  EXPECT_TRUE(shear_layer_survives(Collision::trt, 0.764, 0.3));
  EXPECT_TRUE(shear_layer_survives(Collision::trt, 5, 0.3));
  EXPECT_TRUE(shear_layer_survives(Collision::trt, 0.55, 0.25));
}

TEST(ShearLayer, BreaksWhereTheMapSaysItDoes) {
  // docs/stability.md: at the lowest viscosities only the regularised and Lallemand and Luo's collisions live
  EXPECT_FALSE(shear_layer_survives(Collision::bgk, 0.5001, 0.1));
  EXPECT_FALSE(shear_layer_survives(Collision::trt, 0.5001, 0.1));
  EXPECT_TRUE(shear_layer_survives(Collision::regularised, 0.5001, 0.05));
  EXPECT_TRUE(shear_layer_survives(Collision::lallemand_luo, 0.5001, 0.05));
}

TEST(Percolation, LargestPressureOfThePaperRampedAtItsViscosity) {
  // rho' = 0.36 between the sides: 30 MPa in the paper's lattice units
  const Percolation run = percolate(Collision::trt, 0.764, 0.36, 2000, 0.2);
  EXPECT_TRUE(run.survives);
  EXPECT_GT(run.largest_speed, 0.05);
  EXPECT_LT(run.largest_speed, 0.4);
}

TEST(Percolation, CreepsAtAnyRelaxationTime) {
  for (const double tau : {0.55, 0.764, 1.0, 2.0, 5.0})
    EXPECT_TRUE(percolate(Collision::trt, tau, 1e-6, 0, 0).survives) << tau;
}

TEST(Percolation, LowViscosityAtHighPressureIsLostAndTheGuardSaysWhere) {
  test::Flow<double> flow(12, 12, {true, true}, Collision::bgk, 0.5001);
  flow.set([](int x, int y) { return Macroscopic<double>{0, 0.4 * ((x + y) % 3 - 1), 0.4 * (x % 2)}; });
  int steps = 0;
  while (test::alive(flow) && steps < 5000) {
    flow.sweep();
    ++steps;
  }
  ASSERT_LT(steps, 5000);
  const FlowExtremes found = flow_extremes(flow.exec, flow.nodes, flow.fields, 0.8, 3);
  EXPECT_GE(found.bad, 0);
  EXPECT_LT(found.bad, flow.nodes.count);
}

}  // namespace
}  // namespace vug
