// What must not matter: precision, where in memory a node lies, in which order nodes were born, how the lattice is
// turned.
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace vug {
namespace {

using test::Flow;

/// A staircase obstacle course in a box of 40 x 25 nodes.
bool obstacle(int x, int y) {
  return std::hypot(x - 9.0, y - 8.0) < 4.5 || std::hypot(x - 24.0, y - 17.0) < 5.2 || (x > 30 && x < 34 && y < 12);
}

/// Drives 300 steps from left to right by `pressure`.
template <class T>
void drive(Flow<T>& flow, double pressure) {
  const BoundaryLinks left = flow.side(Side::left), right = flow.side(Side::right);
  const IndexList left_mirror = flow.mirror(left), right_mirror = flow.mirror(right);
  for (int t = 0; t < 300; ++t) {
    dress_pressure(flow.exec, flow.nodes, left, left_mirror, pressure, flow.fields, flow.gain);
    dress_pressure(flow.exec, flow.nodes, right, right_mirror, 0, flow.fields, flow.gain);
    flow.sweep();
  }
}

TEST(FlowInFloat, KeepsItsDigitsFromFastToCreeping) {
  // Populations are deviations from rest, so that float loses no more at 1e-12 than at 1e-2: 24 bits, 300 steps.
  for (const double pressure : {1e-2, 1e-6, 1e-12}) {
    const Lattice lattice(40, 25);
    Flow<float> single(lattice, test::shape(lattice, obstacle), {false, true});
    Flow<double> twice(lattice, test::shape(lattice, obstacle), {false, true});
    drive(single, pressure);
    drive(twice, pressure);
    const auto a = test::host_copy(single.fields.u);
    const auto b = test::host_copy(twice.fields.u);
    double difference = 0, size = 0;
    for (int i = 0; i < twice.nodes.count; ++i)
      for (int axis = 0; axis < 2; ++axis) {
        difference = std::max(difference, std::abs(a(i, axis) - b(i, axis)));
        size = std::max(size, std::abs(b(i, axis)));
      }
    EXPECT_GT(size, 0.1 * pressure);
    EXPECT_LT(difference, 1e-5 * size) << "pressure " << pressure;
  }
}

TEST(FlowOnTheList, SameBitsWhereverABoxLiesInMemory) {
  // two copies of one cavity, one above the other: the second begins in the middle of a block of nodes
  const Lattice lattice(40, 51);
  Flow<double> flow(lattice, test::shape(lattice, [](int x, int y) { return y == 25 || obstacle(x, y % 26); }),
                    {true, false});
  flow.set([](int x, int y) { return Macroscopic<double>{0.01 * std::sin(x), 0.02 * std::cos(y % 26), 0.001 * x}; });
  flow.step.body_force = {1e-4, -2e-5};
  flow.step.speed_limit = 0.015;
  for (int t = 0; t < 101; ++t) flow.sweep();
  const auto u = test::host_copy(flow.fields.u);
  const auto index = test::host_copy(flow.nodes.index);
  for (int y = 0; y < 25; ++y)
    for (int x = 0; x < 40; ++x) {
      const int low = index(lattice.node(x, y)), high = index(lattice.node(x, y + 26));
      if (low < 0) continue;
      ASSERT_EQ(u(low, 0), u(high, 0)) << x << ' ' << y;
      ASSERT_EQ(u(low, 1), u(high, 1)) << x << ' ' << y;
    }
  EXPECT_GT(sum_in_order(flow.step.limited), 0);
}

TEST(FlowOnTheList, SameBitsWhateverTheOrderOfNumbers) {
  // half the nodes are born late, so that they stand at the end of the list
  const Lattice lattice(40, 25);
  const auto type = test::shape(lattice, obstacle);
  const auto state = [](int x, int y) {
    return Macroscopic<double>{0.01 * std::sin(x), 0.02 * std::cos(y), 0.001 * x};
  };
  Flow<double> at_once(lattice, type, {true, true});
  Flow<double> later(lattice,
                     test::shape(lattice, [](int x, int y) { return obstacle(x, y) || (x * 7 + y * 3) % 5 < 2; }),
                     {true, true});
  const int old = later.nodes.count;
  append_births(later.exec, type, later.nodes);
  fit_to_capacity(later.exec, later.nodes, D2Q9::Q, old, later.fields.f, later.fields.u);
  ASSERT_EQ(later.nodes.count, at_once.nodes.count);
  for (Flow<double>* flow : {&at_once, &later}) {
    flow->step.limited = ScalarField<double>("limited", block_count(flow->nodes.capacity));
    flow->set(state);
    for (int t = 0; t < 101; ++t) flow->sweep();
  }
  for (int y = 0; y < 25; ++y)
    for (int x = 0; x < 40; ++x) {
      if (obstacle(x, y)) continue;
      const Macroscopic<double> a = at_once.at(x, y), b = later.at(x, y);
      ASSERT_EQ(a.rho, b.rho) << x << ' ' << y;
      ASSERT_EQ(a.ux, b.ux) << x << ' ' << y;
    }
}

TEST(Flow, MirroredAndTurnedSceneGivesMirroredAndTurnedFlow) {
  const Lattice wide(40, 25), tall(25, 40);
  Flow<double> flow(wide, test::shape(wide, obstacle), {true, true});
  Flow<double> mirror(wide, test::shape(wide, [](int x, int y) { return obstacle(39 - x, y); }), {true, true});
  // turned by 90 degrees: (x, y) -> (24 - y, x)
  Flow<double> turned(tall, test::shape(tall, [](int x, int y) { return obstacle(y, 24 - x); }), {true, true});
  flow.step.body_force = {2e-5, 1e-5};
  mirror.step.body_force = {-2e-5, 1e-5};
  turned.step.body_force = {-1e-5, 2e-5};
  for (int t = 0; t < 500; ++t)
    for (Flow<double>* f : {&flow, &mirror, &turned}) f->sweep();
  const double tolerance = 1e-15 * 500;  // sums in another order; speeds are of order 0.01
  for (int y = 0; y < 25; ++y)
    for (int x = 0; x < 40; ++x) {
      if (obstacle(x, y)) continue;
      const Macroscopic<double> a = flow.at(x, y), b = mirror.at(39 - x, y), c = turned.at(24 - y, x);
      ASSERT_NEAR(a.ux, -b.ux, tolerance);
      ASSERT_NEAR(a.uy, b.uy, tolerance);
      ASSERT_NEAR(a.rho, b.rho, tolerance);
      ASSERT_NEAR(a.ux, c.uy, tolerance);
      ASSERT_NEAR(a.uy, -c.ux, tolerance);
      ASSERT_NEAR(a.rho, c.rho, tolerance);
    }
}

}  // namespace
}  // namespace vug
