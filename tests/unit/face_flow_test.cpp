// What flows through the faces between nodes is what their populations carry: it makes up every change of density.
#include "kernels/flow/face_flow.hpp"

#include "support/flow_setup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug {
namespace {

constexpr int nx = 40, ny = 30;

bool is_disc(int x, int y) {
  return std::hypot(x - 11, y - 9) < 5.3 || std::hypot(x - 29, y - 20) < 7.2;
}

/// A pulse that spreads through joined sides and around discs.
template <class T>
test::Flow<T> pulse() {
  const Lattice lattice(nx, ny);
  test::Flow<T> flow(lattice, test::shape(lattice, is_disc), {true, true});
  flow.set([](int x, int y) {
    return Macroscopic<double>{0.02 * std::sin(0.3 * x) * std::cos(0.4 * y), 0.02 * std::cos(0.5 * y), 0.01};
  });
  return flow;
}

/// Largest difference between what a step adds to a node and what enters through its faces just before.
template <class T>
double unexplained(test::Flow<T>& flow) {
  const FluidNodes& nodes = flow.nodes;
  const VectorField<T> excess("excess", nodes.capacity);
  face_excess(flow.exec, nodes, flow.fields, excess);
  const auto u = test::host_copy(flow.fields.u);
  const auto over = test::host_copy(excess);
  const auto before = test::host_copy(densities(flow.exec, nodes, flow.fields));
  flow.sweep();
  const auto after = test::host_copy(densities(flow.exec, nodes, flow.fields));
  const auto index = test::host_copy(nodes.index);
  const auto node = test::host_copy(nodes.node);
  const auto fluid = [&](int x, int y) { return index(nodes.lattice.node((x + nx) % nx, (y + ny) % ny)); };
  const auto through = [&](int i, int n, int axis) {  // the face between a node and the next along an axis
    return n < 0 || i < 0 ? 0.0 : 0.5 * (double(u(i, axis)) + double(u(n, axis))) - double(over(i, axis));
  };
  double largest = 0;
  for (int i = 0; i < nodes.count; ++i) {
    const int x = nodes.lattice.x(node(i)), y = nodes.lattice.y(node(i));
    const double entered = through(fluid(x - 1, y), i, 0) - through(i, fluid(x + 1, y), 0) +
                           through(fluid(x, y - 1), i, 1) - through(i, fluid(x, y + 1), 1);
    largest = std::max(largest, std::abs(double(after(i)) - double(before(i)) - entered));
  }
  return largest;
}

TEST(FaceFlow, IsWhatChangesTheDensityOfANode) {
  test::Flow<double> flow = pulse<double>();
  for (int step = 0; step < 20; ++step)  // populations at home and turned
    EXPECT_LT(unexplained(flow), 1e-16) << "step " << step;
  test::Flow<float> single = pulse<float>();
  for (int step = 0; step < 20; ++step) EXPECT_LT(unexplained(single), 1e-7) << "step " << step;
}

TEST(FaceFlow, OfAChannelIsThatOfItsVelocity) {
  // between walls along x the velocities of two neighbours are the same and are what flows between them
  const Lattice lattice(8, 9);
  test::Flow<double> flow(lattice, test::shape(lattice, [](int, int y) { return y == 0; }), {true, false});
  flow.step.body_force = {1e-5, 0};
  for (int step = 0; step < 2000; ++step) flow.sweep();
  const VectorField<double> excess("excess", flow.nodes.capacity);
  face_excess(flow.exec, flow.nodes, flow.fields, excess);
  const auto over = test::host_copy(excess);
  for (int i = 0; i < flow.nodes.count; ++i)
    for (int axis = 0; axis < 2; ++axis) EXPECT_LT(std::abs(over(i, axis)), 1e-16);
  EXPECT_GT(flow.at(4, 4).ux, 5e-4);
}

}  // namespace
}  // namespace vug
