// The sweep and what surrounds it, on lattices small enough to check by hand.
#include "kernels/flow/flow.hpp"

#include "kernels/flow/guards.hpp"
#include "kernels/flow/momentum_exchange.hpp"
#include "kernels/nodes/streaming.hpp"
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"
#include "support/populations.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace vug {
namespace {

using test::draw;
using test::Flow;
using test::host_copy;
using test::populations;

template <class T>
void set_population(Flow<T>& flow, int q, int i, T value) {
  settle<D2Q9>(flow.exec, flow.nodes, flow.nodes.count, flow.fields.f, flow.fields.turned);
  Kokkos::deep_copy(Kokkos::subview(flow.fields.f, q * flow.nodes.capacity + i), value);
}

TEST(Sweep, MovesAPopulationToItsNeighbourAndBackFromAWall) {
  // tau = 1 in BGK turns what arrives into its equilibrium: only where it arrives is looked at
  Flow<double> flow(Lattice(3, 1), draw(Lattice(3, 1), {"..#"}), {false, false}, Collision::bgk, 1.0);
  set_population(flow, 1, 0, 0.01);  // moving right at the left node
  flow.sweep();
  EXPECT_EQ(flow.at(0, 0).rho, 0);
  EXPECT_NEAR(flow.at(1, 0).rho, 0.01, 1e-17);
  EXPECT_EQ(flow.at(1, 0).ux, 0.01);
  flow.set([](int, int) { return Macroscopic<double>{0, 0, 0}; });
  set_population(flow, 1, 1, 0.01);  // moving into the solid node
  flow.sweep();
  EXPECT_NEAR(flow.at(1, 0).rho, 0.01, 1e-17);
  EXPECT_EQ(flow.at(1, 0).ux, -0.01);
}

TEST(Sweep, KeepsMassInAClosedCavity) {
  for (const Collision c : {Collision::trt, Collision::lallemand_luo, Collision::bgk, Collision::regularised}) {
    Flow<double> flow(Lattice(5, 4), draw(Lattice(5, 4), {"..#..", ".....", "#..#.", "....."}), {false, false}, c);
    flow.set([](int x, int y) { return Macroscopic<double>{0.01 * x - 0.02 * y, 0.01 * y, -0.02 * x}; });
    const double before = flow.mass();
    for (int t = 0; t < 100; ++t) flow.sweep();
    EXPECT_NEAR(flow.mass(), before, 1e-14);  // 100 steps of round-off on 17 nodes
  }
}

TEST(Sweep, RestAtAnyPressureStaysAtRest) {
  Flow<float> flow(Lattice(4, 3), draw(Lattice(4, 3), {"....", ".#..", "...."}), {false, true});
  flow.set([](int, int) { return Macroscopic<double>{0.36, 0, 0}; });
  for (int t = 0; t < 50; ++t) flow.sweep();
  const FlowExtremes extremes = flow_extremes(flow.exec, flow.nodes, flow.fields, 1, 1);
  EXPECT_LT(extremes.speed, 1e-6);  // float round-off of populations of size 0.16
  EXPECT_NEAR(extremes.density, 0.36, 1e-6);
}

TEST(SpeedLimiter, RemovesMomentumKeepsMassAndCounts) {
  Flow<double> flow(3, 3, {true, true});
  flow.set([](int x, int) { return Macroscopic<double>{0.01, x == 1 ? 0.3 : 0.1, 0}; });
  const double before = flow.mass();
  flow.step.speed_limit = 0.2;
  flow.step.rates = relaxation_rates(Collision::bgk, 1);
  flow.sweep();
  EXPECT_NEAR(flow.mass(), before, 1e-15);
  double uses = 0;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y) {
      const Macroscopic<double> m = flow.at(x, y);
      EXPECT_LE(std::hypot(m.ux, m.uy), 0.2 + 1e-15);
      if (m.ux > 0.2 - 1e-12) ++uses;
    }
  EXPECT_GT(uses, 0);
  EXPECT_EQ(sum_in_order(flow.step.limited), uses);
  const double counted = uses;
  flow.sweep();  // whatever is over the limit now is added
  EXPECT_GE(sum_in_order(flow.step.limited), counted);
}

/// Uniform flow faster than the limit keeps its direction and gets the speed of the limit, at every node.
template <class T>
void expect_limited(std::array<double, 2> direction) {
  Flow<T> flow(23, 11, {true, true});
  flow.set([&](int, int) { return Macroscopic<double>{0.01, 0.3 * direction[0], 0.3 * direction[1]}; });
  flow.step.speed_limit = 0.2;
  flow.step.rates = relaxation_rates(Collision::bgk, 1);
  flow.sweep();
  for (const auto& [x, y] : std::array<std::array<int, 2>, 3>{{{0, 0}, {22, 10}, {13, 4}}}) {
    EXPECT_NEAR(flow.at(x, y).ux, 0.2 * direction[0], 1e-6) << x;
    EXPECT_NEAR(flow.at(x, y).uy, 0.2 * direction[1], 1e-6) << x;
  }
  EXPECT_EQ(sum_in_order(flow.step.limited), 23 * 11);
}

TEST(SpeedLimiter, HoldsTheSpeedInAnyDirection) {
  for (const std::array<double, 2> direction : {std::array{1.0, 0.0}, {0.0, -1.0}, {-0.6, 0.8}}) {
    expect_limited<double>(direction);
    expect_limited<float>(direction);
  }
}

TEST(SpeedLimiter, ChangesNothingBelowTheLimit) {
  const auto state = [](int x, int y) { return Macroscopic<double>{0.01 * x, 0.02 * y, -0.01 * x}; };
  Flow<double> free(4, 5, {true, false}), limited(4, 5, {true, false});
  free.set(state);
  limited.set(state);
  limited.step.speed_limit = 0.4;
  for (int t = 0; t < 10; ++t) {
    free.sweep();
    limited.sweep();
  }
  EXPECT_EQ(sum_in_order(limited.step.limited), 0);
  for (int i = 0; i < free.nodes.count; ++i)
    for (int q = 0; q < 9; ++q)
      // not bitwise: the two loops may contract multiplications and additions differently
      EXPECT_NEAR(populations(free, i)[q], populations(limited, i)[q], 1e-16);
}

TEST(PressureBoundary, HoldsRestAtItsPressureAndBooksMass) {
  Flow<double> flow(4, 3, {false, false});
  const double p = 0.05;
  flow.set([&](int, int) { return Macroscopic<double>{3 * p, 0, 0}; });
  const BoundaryLinks left = flow.side(Side::left);
  const IndexList mirror = flow.mirror(left);
  for (int t = 0; t < 20; ++t) {
    dress_pressure(flow.exec, flow.nodes, left, mirror, p, flow.fields, flow.gain);
    flow.sweep();
  }
  EXPECT_NEAR(flow.at(2, 1).rho, 3 * p, 1e-15);
  EXPECT_NEAR(flow.at(0, 0).ux, 0, 1e-15);
  EXPECT_NEAR(sum_in_order(flow.gain), 0, 1e-14);  // 20 steps of round-off on 9 links
}

TEST(OpenBoundaries, MassInTheBoxIsWhatTheyBooked) {
  Flow<double> flow(6, 5, {false, false});
  const BoundaryLinks left = flow.side(Side::left), right = flow.side(Side::right), top = flow.side(Side::top);
  const IndexList left_mirror = flow.mirror(left), right_mirror = flow.mirror(right);
  const ScalarField<double> gain_right("gain", 100), gain_top("gain", 100);
  OutflowState outflow;
  fit_to_links(flow.exec, flow.nodes, right, outflow);
  for (int t = 0; t < 200; ++t) {
    dress_pressure(flow.exec, flow.nodes, left, left_mirror, 0.01, flow.fields, flow.gain);
    dress_outflow(flow.exec, flow.nodes, right, right_mirror, outflow, flow.fields, gain_right);
    dress_velocity(flow.exec, flow.nodes, top, {0.02, -0.01}, flow.fields, gain_top);
    flow.sweep();
  }
  const double booked = sum_in_order(flow.gain) + sum_in_order(gain_right) + sum_in_order(gain_top);
  EXPECT_GT(std::abs(sum_in_order(gain_right)), 0.01);  // something did flow
  EXPECT_NEAR(flow.mass(), booked, 1e-13);              // 200 steps of round-off
}

TEST(VelocityBoundary, LetsInItsFluxOfFluid) {
  Flow<double> flow(4, 7, {false, false});
  const BoundaryLinks left = flow.side(Side::left);
  dress_velocity(flow.exec, flow.nodes, left, {0.03, 0.01}, flow.fields, flow.gain);
  EXPECT_NEAR(sum_in_order(flow.gain), 7 * 0.03, 1e-15);  // seven faces
}

TEST(OutflowBoundary, PassesUniformFlowUnchangedWhateverItsDirection) {
  Flow<double> flow(8, 4, {false, true});
  flow.set([](int, int) { return Macroscopic<double>{0, 0.05, 0.02}; });
  const BoundaryLinks left = flow.side(Side::left), right = flow.side(Side::right);
  const IndexList mirror = flow.mirror(right);
  OutflowState outflow;
  fit_to_links(flow.exec, flow.nodes, right, outflow);
  Kokkos::deep_copy(Kokkos::subview(outflow.level, 0), 0.05);  // it has flowed so for long
  for (int t = 0; t < 100; ++t) {
    dress_velocity(flow.exec, flow.nodes, left, {0.05, 0.02}, flow.fields, flow.gain);
    dress_outflow(flow.exec, flow.nodes, right, mirror, outflow, flow.fields, flow.gain);
    flow.sweep();
  }
  for (int x = 0; x < 8; ++x) {
    EXPECT_NEAR(flow.at(x, 2).ux, 0.05, 1e-14);
    EXPECT_NEAR(flow.at(x, 2).uy, 0.02, 1e-14);
    EXPECT_NEAR(flow.at(x, 2).rho, 0, 1e-14);
  }
}

TEST(FlowBirths, TakeTheMeanOfOldNeighboursInAnyOrder) {
  const Lattice lattice(4, 3);
  Flow<double> flow(lattice, draw(lattice, {"..##", "..##", "..##"}), {false, false});
  flow.set([](int x, int y) { return Macroscopic<double>{0.1 * x + 0.01 * y, 0.02, 0.01}; });
  const int old = flow.nodes.count;
  flow.type = draw(lattice, {"..##", "...#", "...."});
  ASSERT_EQ(append_births(flow.exec, flow.type, flow.nodes), 3);
  fit_to_capacity(flow.exec, flow.nodes, D2Q9::Q, old, flow.fields.f, flow.fields.u);
  const double before = flow.mass();
  initialise_births(flow.exec, flow.nodes, old, flow.nodes.count, flow.fields);
  const double low = (0.1 + 0.11) / 2, middle = (0.1 + 0.11 + 0.12) / 3;
  EXPECT_NEAR(flow.at(2, 0).rho, low, 1e-15);
  EXPECT_NEAR(flow.at(2, 1).rho, middle, 1e-15);
  EXPECT_EQ(flow.at(3, 0).rho, 0);  // touches new nodes only
  const auto f = populations(flow, host_copy(flow.nodes.index)(lattice.node(2, 1)));
  for (int q = 0; q < 9; ++q) EXPECT_NEAR(f[q], D2Q9::w(q) * middle, 1e-16);
  EXPECT_EQ(flow.at(2, 1).ux, 0);
  EXPECT_NEAR(flow.mass() - before, low + middle, 1e-15);
}

TEST(FlowBirths, GrowingTheCapacityKeepsTheState) {
  const Lattice lattice(9, 9);
  Flow<float> flow(lattice, test::shape(lattice, [](int x, int) { return x > 1; }), {false, false});
  flow.set([](int x, int y) { return Macroscopic<double>{0.1 * x + 0.01 * y, 0.02, -0.01 * y}; });
  const int old = flow.nodes.count, old_capacity = flow.nodes.capacity;
  const auto before = populations(flow, 17);
  append_births(flow.exec, test::shape(lattice, [](int, int) { return false; }), flow.nodes);
  ASSERT_GT(flow.nodes.capacity, old_capacity);
  fit_to_capacity(flow.exec, flow.nodes, D2Q9::Q, old, flow.fields.f, flow.fields.u);
  EXPECT_EQ(populations(flow, 17), before);
  EXPECT_EQ(flow.at(1, 8).uy, -0.08f);
  initialise_births(flow.exec, flow.nodes, old, flow.nodes.count, flow.fields);
  flow.sweep();
  EXPECT_EQ(flow_extremes(flow.exec, flow.nodes, flow.fields, 1, 2).bad, -1);
}

TEST(FlowGuard, NamesTheFirstBadNodeAndTheExtremes) {
  Flow<double> flow(5, 4, {true, true});
  flow.set([](int x, int y) { return Macroscopic<double>{-0.01 * y, 0.01 * x, 0}; });
  FlowExtremes found = flow_extremes(flow.exec, flow.nodes, flow.fields, 0.4, 1);
  EXPECT_NEAR(found.speed, 0.04, 1e-15);
  EXPECT_NEAR(found.density, 0.03, 1e-15);
  EXPECT_EQ(found.bad, -1);
  EXPECT_EQ(flow_extremes(flow.exec, flow.nodes, flow.fields, 0.035, 1).bad, 4);
  EXPECT_EQ(flow_extremes(flow.exec, flow.nodes, flow.fields, 0.4, 0.025).bad, 15);
  // one step on, a broken population is seen where it arrives: at (2, 1) + (-1, 1) = (1, 2), number 11
  set_population(flow, 6, 7, std::numeric_limits<double>::quiet_NaN());
  set_population(flow, 0, 13, std::numeric_limits<double>::infinity());
  flow.sweep();
  EXPECT_EQ(flow_extremes(flow.exec, flow.nodes, flow.fields, 0.4, 1).bad, 11);
}

}  // namespace
}  // namespace vug
