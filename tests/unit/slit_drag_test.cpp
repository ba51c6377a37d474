// The force of slow fluid on the walls of a slit narrower than a cell, by hand.
#include "kernels/flow/slit_drag.hpp"

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
  slits.fluid = to_device<IndexList>("fluid", {7, 16});
  slits.first = to_device<IndexList>("first", {0, 2});
  slits.resistance = to_device<ScalarField<double>>("resistance", {3, 4});
  const VectorField<double> centre("centre", 1), force("force", 1);
  const ScalarField<double> torque("torque", 1);
  test::edit(centre, [&](const auto& c) { c(0, 0) = 2.2 * spacing, c(0, 1) = 1.7 * spacing; });
  test::edit(force, [](const auto& f) { f(0, 0) = 100; });  // is added to
  const auto u = on_host(flow.fields.u);
  const auto node = on_host(flow.nodes.node);
  double x = 0, y = 0, turning = 0;
  for (int k = 0; k < 2; ++k) {
    const int i = 7 + 9 * k;
    const double fx = nu * (3 + k) * u(i, 0), fy = nu * (3 + k) * u(i, 1);
    x += fx, y += fy;
    turning += (flow.lattice.x(node(i)) + 0.5 - 2.2) * fy - (flow.lattice.y(node(i)) + 0.5 - 1.7) * fx;
  }
  ASSERT_GT(std::abs(x), 1e-4);
  ASSERT_GT(std::abs(y), 1e-4);
  ASSERT_GT(std::abs(turning), 1e-4);
  add_slit_drag(flow.exec, flow.nodes, slits, nu, flow.step, flow.fields, centre, spacing, newton, newton_metre, force,
                torque);
  const auto on_walls = test::host_copy(force);
  EXPECT_NEAR((on_walls(0, 0) - 100) / (newton * x), 1, 1e-9);
  EXPECT_NEAR(on_walls(0, 1) / (newton * y), 1, 1e-12);
  EXPECT_NEAR(test::host_copy(torque)(0) / (newton_metre * turning), 1, 1e-12);
}

}  // namespace
}  // namespace vug
