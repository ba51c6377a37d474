// The force of slow fluid on the walls of a slit narrower than a cell, by hand.
#include "kernels/flow/slit_nodes.hpp"
#include "support/flow_setup.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

/// Darcy: F = nu u / k on the walls, and its torque about their centre by the arm from there to the middle of the node;
/// two slits in one group, in SI by the factors of force and torque.
TEST(SlitDrag, IsTheForceAndTorqueOfDarcysLaw) {
  const double nu = 0.1, spacing = 2e-3, newton = 5, newton_metre = 7;
  test::Flow<double> flow(6, 5, {true, true});
  flow.set([](int x, int y) { return Macroscopic<double>{0.01, 0.002 * x, -0.003 * y}; });
  flow.sweep();
  SlitNodes slits;
  slits.count = 2;
  slits.fluid = IndexList("fluid", 2);
  slits.first = IndexList("first", 2);
  slits.resistance = ScalarField<double>("resistance", 2);
  const VectorField<double> centre("centre", 1), force("force", 1);
  const ScalarField<double> torque("torque", 1);
  centre(0, 0) = 2.2 * spacing, centre(0, 1) = 1.7 * spacing;
  force(0, 0) = 100;  // is added to
  slits.first(1) = 2;
  double x = 0, y = 0, turning = 0;
  for (int k = 0; k < 2; ++k) {
    const int i = 7 + 9 * k;
    slits.fluid(k) = i;
    slits.resistance(k) = 3 + k;
    const double fx = nu * (3 + k) * flow.fields.u(i, 0), fy = nu * (3 + k) * flow.fields.u(i, 1);
    const int node = flow.nodes.node(i);
    x += fx, y += fy;
    turning += (flow.lattice.x(node) + 0.5 - 2.2) * fy - (flow.lattice.y(node) + 0.5 - 1.7) * fx;
  }
  ASSERT_GT(std::abs(x), 1e-4);
  ASSERT_GT(std::abs(y), 1e-4);
  ASSERT_GT(std::abs(turning), 1e-4);
  add_slit_drag(flow.exec, flow.nodes, slits, nu, flow.step, flow.fields, centre, spacing, newton, newton_metre, force,
                torque);
  flow.exec.fence();
  EXPECT_NEAR((force(0, 0) - 100) / (newton * x), 1, 1e-9);
  EXPECT_NEAR(force(0, 1) / (newton * y), 1, 1e-12);
  EXPECT_NEAR(torque(0) / (newton_metre * turning), 1, 1e-12);
}

}  // namespace
}  // namespace vug
