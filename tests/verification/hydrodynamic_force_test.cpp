// Forces of the fluid on the rock by momentum exchange.
#include "kernels/nodes/streaming.hpp"
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"
#include "support/node_force.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace vug {
namespace {

using test::Flow;

struct Force {
  double x = 0, y = 0;
};

/// Sum over the surface nodes for which where(x, y) holds.
template <class T, class Where>
Force force_on(const Flow<T>& flow, const Where& where) {
  Surface surface;
  find_surface(flow.exec, flow.nodes, flow.type, surface);
  const auto values = test::NodeForce<T>(flow, surface)(flow);
  const auto node = test::host_copy(surface.node);
  Force total;
  for (int s = 0; s < surface.count; ++s) {
    if (!where(flow.lattice.x(node(s)), flow.lattice.y(node(s)))) continue;
    total.x += values(s, 0);
    total.y += values(s, 1);
  }
  return total;
}
constexpr auto everywhere = [](int, int) { return true; };

TEST(HydrostaticForce, IsPressureTimesProjectedLengthOnAnyStaircase) {
  // a bank whose surface climbs in steps of one to three nodes, under fluid at rest
  const Lattice lattice(12, 12);
  const int height[12] = {2, 2, 3, 3, 5, 6, 7, 7, 4, 4, 3, 2};
  const auto type = test::shape(lattice, [&](int x, int y) { return y < height[x]; });
  Flow<double> flow(lattice, type, {true, false});
  const double p = 0.07;
  flow.set([&](int, int) { return Macroscopic<double>{3 * p, 0, 0}; });
  flow.sweep();
  const Force all = force_on(flow, everywhere);
  EXPECT_NEAR(all.x, 0, 1e-14);
  EXPECT_NEAR(all.y, -12 * p, 1e-14);
  // nodes of the rising flank meet the falling one at a column whose neighbours are level: cut there
  const Force flank = force_on(flow, [](int x, int) { return x >= 1 && x <= 6; });
  EXPECT_NEAR(flank.x, 5 * p, 1e-14);
  EXPECT_NEAR(flank.y, -6 * p, 1e-14);
}

TEST(HydrostaticForce, VanishesOnASubmergedBody) {
  const Lattice lattice(20, 20);
  const auto type = test::shape(lattice, [](int x, int y) { return std::hypot(x - 9.2, y - 9.7) < 5.3; });
  Flow<float> flow(lattice, type, {true, true});
  flow.set([](int, int) { return Macroscopic<double>{0.3, 0, 0}; });
  flow.sweep();
  const Force total = force_on(flow, everywhere);
  EXPECT_NEAR(total.x, 0, 1e-6);  // float round-off of some 150 links of size 0.01
  EXPECT_NEAR(total.y, 0, 1e-6);
}

TEST(HydrostaticForce, TurnsABankByTheLeverArmsOfItsNodes) {
  const Lattice lattice(12, 12);
  const auto type = test::shape(lattice, [](int x, int y) { return y < (x < 5 ? 2 : 5); });
  Flow<double> flow(lattice, type, {false, false});
  const double p = 0.07, spacing = 0.5;
  flow.set([&](int, int) { return Macroscopic<double>{3 * p, 0, 0}; });
  Surface surface;
  find_surface(flow.exec, flow.nodes, flow.type, surface);
  const IndexList all("all", 2);
  Kokkos::deep_copy(Kokkos::subview(all, 1), surface.count);
  const VectorField<double> centre("centre", 1), force("force", 1);
  const ScalarField<double> torque("torque", 1);
  Kokkos::deep_copy(Kokkos::subview(centre, 0, 0), spacing * 3.25);
  Kokkos::deep_copy(Kokkos::subview(centre, 0, 1), spacing * 1.5);
  WallLinks links;
  find_wall_links(flow.exec, flow.nodes, all, surface.node, centre, spacing, links);
  exchange_momentum(flow.exec, flow.fields, links, 2, 3, force, torque);
  double x = 0, y = 0, turning = 0;  // node by node, from the forces on single nodes
  const auto single = test::NodeForce<double>(flow, surface)(flow);
  const auto node = test::host_copy(surface.node);
  for (int s = 0; s < surface.count; ++s) {
    x += single(s, 0);
    y += single(s, 1);
    turning += (lattice.x(node(s)) + 0.5 - 3.25) * single(s, 1) - (lattice.y(node(s)) + 0.5 - 1.5) * single(s, 0);
  }
  EXPECT_GT(std::abs(turning), p);
  EXPECT_NEAR(test::host_copy(force)(0, 0), 2 * x, 1e-13);
  EXPECT_NEAR(test::host_copy(force)(0, 1), 2 * y, 1e-13);
  EXPECT_NEAR(test::host_copy(torque)(0), 3 * turning, 1e-13);
}

TEST(HydrodynamicForce, BalancesTheMomentumOfTheFluidAtEveryStep) {
  // d/dt sum u = F n - force on the solid, exactly, also far from steady
  const Lattice lattice(16, 14);
  const auto type = test::shape(lattice, [](int x, int y) { return y == 0 || std::hypot(x - 7.0, y - 6.0) < 2.6; });
  Flow<double> flow(lattice, type, {true, true}, Collision::trt, 0.7);
  flow.step.body_force = {1e-4, -3e-5};
  const auto momentum = [&] {
    settle<D2Q9>(flow.exec, flow.nodes, flow.nodes.count, flow.fields.f, flow.fields.turned);
    const auto f = test::host_copy(flow.fields.f);
    Force sum;
    for (int q = 1; q < 9; ++q)
      for (int i = 0; i < flow.nodes.count; ++i) {
        sum.x += D2Q9::c(q, 0) * f(q * flow.nodes.capacity + i);
        sum.y += D2Q9::c(q, 1) * f(q * flow.nodes.capacity + i);
      }
    return sum;
  };
  for (int t = 0; t < 60; ++t) {
    const Force before = momentum(), on_solid = force_on(flow, everywhere);
    flow.sweep();
    const Force after = momentum();
    EXPECT_NEAR(after.x - before.x, 1e-4 * flow.nodes.count - on_solid.x, 1e-14);
    EXPECT_NEAR(after.y - before.y, -3e-5 * flow.nodes.count - on_solid.y, 1e-14);
  }
}

TEST(HydrodynamicForce, HeldForSomeStepsGivesTheSameImpulse) {
  // a disc in fluid that a body force sets in motion: no bias where every second step is of one kind of streaming
  const Lattice lattice(40, 32);
  const auto type = test::shape(lattice, [](int x, int y) { return std::hypot(x - 14.3, y - 15.6) < 5.2; });
  Flow<double> flow(lattice, type, {true, true}, Collision::trt, 0.764);
  flow.step.body_force = {1e-5, 0};
  constexpr int steps = 1200;
  double all = 0, last = 0;
  std::array<double, 9> held{};
  for (int t = 0; t < steps; ++t) {
    last = force_on(flow, everywhere).x;
    all += last;
    for (const int n : {2, 3, 4, 8})
      if (t % n == 0) held[n] += n * last;
    flow.sweep();
  }
  EXPECT_GT(last, 0);
  for (const int n : {2, 3, 4, 8}) {
    const double lag = 0.5 * (n - 1) * last / all;      // of what is held while the force rises from nothing
    EXPECT_NEAR(held[n] / all, 1 - lag, lag / 3) << n;  // the sound of the sudden start is sampled, 1e-4 of the impulse
  }
}

TEST(HydrodynamicForce, OnADiscTurnsWithTheLattice) {
  const int n = 31;
  const Lattice lattice(n, n);
  const auto solid = [](double x, double y) { return std::hypot(x - 13.3, y - 16.1) < 4.4; };
  Flow<double> east(lattice, test::shape(lattice, [&](int x, int y) { return solid(x, y); }), {true, true});
  // turned by 90 degrees about the centre: (x, y) -> (n - 1 - y, x)
  Flow<double> north(lattice, test::shape(lattice, [&](int x, int y) { return solid(y, n - 1 - x); }), {true, true});
  east.step.body_force = {1e-5, 2e-6};
  north.step.body_force = {-2e-6, 1e-5};
  for (int t = 0; t < 500; ++t) {
    east.sweep();
    north.sweep();
  }
  const Force a = force_on(east, everywhere), b = force_on(north, everywhere);
  EXPECT_GT(a.x, 1e-3);                      // a real drag, about F n^2 when steady
  EXPECT_NEAR(b.y, a.x, 1e-13 * a.x * 100);  // order of sums differs: round-off of 500 steps
  EXPECT_NEAR(b.x, -a.y, 1e-13 * a.x * 100);
}

TEST(HydrodynamicForce, OfAMovingWallIsTheMeanBeforeAndAfterDressing) {
  // Couette between a solid floor that slides and a side at rest: shear stress nu u/h on every node of the floor
  constexpr int h = 6;
  const Lattice lattice(4, h + 1);
  Flow<double> flow(lattice, test::shape(lattice, [](int, int y) { return y == 0; }), {true, false});
  BoundaryLinks floor;
  floor.fluid = IndexList("fluid", 12);
  floor.direction = Kokkos::View<std::uint8_t*>("direction", 12);
  const auto fluid = Kokkos::create_mirror_view(floor.fluid);
  const auto direction = Kokkos::create_mirror_view(floor.direction);
  const auto index = test::host_copy(flow.nodes.index);
  for (int x = 0; x < 4; ++x)
    for (const int q : {4, 7, 8}) {
      fluid(floor.count) = index(lattice.node(x, 1));
      direction(floor.count++) = static_cast<std::uint8_t>(q);
    }
  Kokkos::deep_copy(floor.fluid, fluid);
  Kokkos::deep_copy(floor.direction, direction);
  const double speed = 0.04, nu = (0.8 - 0.5) / 3;
  Force before, after;
  for (int t = 0; t < 4000; ++t) {
    if (t == 3999) before = force_on(flow, everywhere);
    dress_velocity(flow.exec, flow.nodes, floor, {speed, 0}, flow.fields, flow.gain);
    if (t == 3999) after = force_on(flow, everywhere);
    flow.sweep();
  }
  EXPECT_NEAR((before.x + after.x) / 2, -4 * nu * speed / h, 1e-14);
}

}  // namespace
}  // namespace vug
