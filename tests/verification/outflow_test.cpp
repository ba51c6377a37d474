// What an outflow does to the flow that meets it.
#include "support/record.hpp"
#include "verification/open_channel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace vug {
namespace {

using namespace test::open_channel;
using test::Flow;
using test::record;

TEST(Outflow, DevelopedProfileLeavesUnchangedInEveryDirectionAndCollision) {
  // Plug flow enters; after five widths, e^-21 of it is left. What remains is inertia, of the order of the speed.
  constexpr int width = 8, length = 6 * width;
  constexpr double mean = 1e-7;
  for (const Side outlet : all_sides)
    for (int c = 0; c < 4; ++c) {
      if (c > 0 && outlet != Side::top) continue;
      Channel channel(collisions[c], outlet, length, width);
      const BoundaryLinks fed = channel.side(channel.inlet(), true);
      channel.run_to_rest(1e-12, [&] {
        dress_velocity(channel.flow.exec, channel.flow.nodes, fed, channel.towards_outlet(mean), channel.flow.fields,
                       channel.flow.gain);
        channel.let_out();
      });
      const auto fields = channel.fields();
      double flow_rate = 0, unit_rate = 0, profile = 0, pressure = 0;
      for (int across = 0; across < width; ++across) {
        flow_rate += fields[(length - 1) * width + across].ux;
        unit_rate += node_speed(collisions[c], 1, width, across);
      }
      EXPECT_NEAR(flow_rate / width / mean, 1, 1e-6);
      const double gradient = flow_rate / unit_rate;
      for (int along = length - width / 2; along < length; ++along)
        for (int across = 0; across < width; ++across) {
          const Macroscopic<double> m = fields[along * width + across];
          profile =
              std::max({profile, std::abs(m.ux - node_speed(collisions[c], gradient, width, across)), std::abs(m.uy)});
          // the side, half a cell beyond the last node, is at the reference pressure
          pressure = std::max(pressure, std::abs(m.rho / 3 - gradient * (length - along - 0.5)));
        }
      EXPECT_LT(profile / mean, 1e-6) << names[c] << " to the " << name_of(outlet);
      EXPECT_LT(pressure / (gradient * length), 1e-6) << names[c] << " to the " << name_of(outlet);
      record("flow_outflow_profile", {{"collision", names[c]}, {"side", name_of(outlet)}, {"error", profile / mean}});
    }
}

/// A uniform flow U towards `outlet`, between joined sides.
struct CarryingFlow {
  static constexpr int width = 64;
  Side outlet;
  int length;
  double U;
  Flow<double> flow;
  BoundaryLinks in, out;
  IndexList mirror;
  OutflowState state;

  CarryingFlow(Side outlet_side, int cells, double speed)
      : outlet(outlet_side),
        length(cells),
        U(speed),
        flow(upright() ? width : length, upright() ? length : width, {upright(), !upright()}, Collision::trt, 0.53),
        in(flow.side(static_cast<Side>(D2Q9::opposite(static_cast<int>(outlet))))),
        out(flow.side(outlet)),
        mirror(flow.mirror(out)) {
    fit_to_links(flow.exec, flow.nodes, out, state);
    Kokkos::deep_copy(Kokkos::subview(state.level, 0), U);
  }
  bool upright() const { return outlet == Side::top || outlet == Side::bottom; }
  bool backwards() const { return outlet == Side::left || outlet == Side::bottom; }

  /// Adds a Gaussian vortex of radius 8 to the flow, `along` cells from the inlet.
  void set_vortex(double speed, double along, double across) {
    constexpr double R = 8;
    flow.set([&](int x, int y) {
      const int s = upright() ? y : x, t = upright() ? x : y;
      const double ds = (backwards() ? length - 1 - s : s) - along, dt = std::remainder(t - across, width);
      const double r2 = (ds * ds + dt * dt) / (R * R), turn = speed * std::exp(0.5 * (1 - r2)) / R;
      const double us = (backwards() ? -1 : 1) * (U - turn * dt), ut = turn * ds;
      return Macroscopic<double>{-1.5 * speed * speed * std::exp(1 - r2), upright() ? ut : us, upright() ? us : ut};
    });
  }
  void run(int steps) {
    const int q = static_cast<int>(outlet);
    for (int t = 0; t < steps; ++t) {
      dress_velocity(flow.exec, flow.nodes, in, {U * D2Q9::c(q, 0), U * D2Q9::c(q, 1)}, flow.fields, flow.gain);
      dress_outflow(flow.exec, flow.nodes, out, mirror, state, flow.fields, flow.gain);
      flow.sweep();
    }
  }
  /// Outward and other velocity, less U, of the first `cells` from the inlet.
  std::vector<double> disturbance(int cells) const {
    const auto u = test::host_copy(flow.fields.u);
    const auto index = test::host_copy(flow.nodes.index);
    std::vector<double> all;
    for (int along = 0; along < cells; ++along)
      for (int across = 0; across < width; ++across) {
        const int s = backwards() ? length - 1 - along : along;
        const int i = index(upright() ? flow.lattice.node(across, s) : flow.lattice.node(s, across));
        all.push_back((backwards() ? -1 : 1) * u(i, upright() ? 1 : 0) - U);
        all.push_back(u(i, upright() ? 0 : 1));
      }
    return all;
  }
};

double energy(const std::vector<double>& velocity) {
  return std::inner_product(velocity.begin(), velocity.end(), velocity.begin(), 0.0);
}

/// Largest share of the energy of a vortex that an outflow sends back, and what is left at the end: against the same
/// vortex in a lattice twice as long.
std::pair<double, double> echo_and_rest(Side outlet, double speed, double across) {
  constexpr int length = 100;
  constexpr double U = 0.05;
  CarryingFlow near(outlet, length, U), far(outlet, 2 * length, U);
  for (CarryingFlow* flow : {&near, &far}) flow->set_vortex(speed * U, 50, across);
  const double start = energy(near.disturbance(length));
  double echo = 0;
  for (int k = 0; k < 20; ++k) {
    near.run(100);
    far.run(100);
    std::vector<double> difference = near.disturbance(length);
    const std::vector<double> free = far.disturbance(length);
    for (std::size_t n = 0; n < free.size(); ++n) difference[n] -= free[n];
    echo = std::max(echo, energy(difference) / start);
  }
  return {echo, energy(near.disturbance(length)) / start};
}

TEST(Outflow, AVortexLeavesWithoutAnEcho) {
  for (const double speed : {0.2, 0.5, 1.0}) {
    const auto [echo, left] = echo_and_rest(Side::right, speed, 32.3);
    std::printf("    vortex of %.1f U: %.2e of its energy comes back, %.2e is left\n", speed, echo, left);
    record("flow_outflow_vortex", {{"speed", speed}, {"echo", echo}, {"left", left}});
    EXPECT_LT(echo, 0.001);
    EXPECT_LT(left, 1e-5);
  }
}

TEST(Outflow, AVortexLeavesAlikeThroughEverySideAndAnywhereOnIt) {
  const double echo = echo_and_rest(Side::right, 1, 32.3).first;
  for (const Side outlet : all_sides) EXPECT_NEAR(echo_and_rest(outlet, 1, 32.3).first, echo, 1e-6 * echo);
  EXPECT_NEAR(echo_and_rest(Side::top, 1, 0.3).first, echo, 1e-6 * echo);  // where the joined sides meet
}

TEST(Outflow, HasInEveryPieceOfItsOwnThePressureOfTheLaw) {
  // u = U + a (y - centre of the piece), v = b + c x on the side: p = -a c (y - centre)^2 / 2 + constant, of which a
  // flow that fast carries its share; two pieces, rock between them
  constexpr int nx = 12, ny = 40;
  constexpr double U = 0.05, a = 1e-3, b = 2e-3, c = 3e-3;
  const auto rock = [](int, int y) { return y >= 10 && y < 13; };
  const auto offset = [](int y) { return y < 10 ? y - 4.5 : y - 26; };
  const Lattice lattice(nx, ny);
  Flow<double> flow(lattice, test::shape(lattice, rock), {false, false});
  flow.set([&](int x, int y) { return Macroscopic<double>{0, U + a * offset(y), b + c * (x - (nx - 1))}; });
  const BoundaryLinks out = flow.side(Side::right);
  OutflowState state;
  fit_to_links(flow.exec, flow.nodes, out, state);
  dress_outflow(flow.exec, flow.nodes, out, flow.mirror(out), state, flow.fields, flow.gain);
  const auto along = test::host_copy(state.along);
  const auto face = test::host_copy(state.face);
  const auto fluid = test::host_copy(out.fluid), node = test::host_copy(flow.nodes.node);
  const auto direction = test::host_copy(out.direction);
  for (int link = 0; link < out.count; ++link) {
    ASSERT_EQ(fluid(face(link)), fluid(link));
    ASSERT_EQ(direction(face(link)), 1);
    const int y = lattice.y(node(fluid(link))), n = y < 10 ? 10 : 27;
    const double squares = (n * n - 1) / 12.0;  // mean of (y - centre)^2
    const double share = U * U / (U * U + a * a * squares + b * b);
    EXPECT_NEAR(along(face(link)), 3 * share * -a * c * (offset(y) * offset(y) - squares) / 2, 1e-15) << y;
  }
}

TEST(Outflow, WhatIsNotCarriedOutDiesAwayBesideIt) {
  // no flow, or one far weaker than the vortex, goes through the side
  for (const double U : {0.0, 0.002}) {
    CarryingFlow beside(Side::right, 100, U);
    beside.set_vortex(0.06, 84, 32.3);
    const double start = energy(beside.disturbance(100));
    beside.run(6000);
    const double left = energy(beside.disturbance(100)) / start;
    std::printf("    vortex of 0.06 beside an outflow of %g: %.2e of its energy is left\n", U, left);
    EXPECT_LT(left, 0.9);  // carried out as if it moved with a flow it would grow without bound
  }
}

TEST(Outflow, SoundLeavesAndThePressureReturnsToItsReference) {
  // Fluid at rest is pushed at once: sound of c_s U runs down the lattice of 100 cells, which it crosses in 173 steps.
  constexpr int nx = 100;
  constexpr double U = 0.02;
  Flow<double> flow(nx, 4, {false, true}, Collision::trt, tau);
  const BoundaryLinks in = flow.side(Side::left), out = flow.side(Side::right);
  const IndexList mirror = flow.mirror(out);
  OutflowState state;
  fit_to_links(flow.exec, flow.nodes, out, state);
  const auto run = [&](int steps) {
    for (int t = 0; t < steps; ++t) {
      dress_velocity(flow.exec, flow.nodes, in, {U, 0}, flow.fields, flow.gain);
      dress_outflow(flow.exec, flow.nodes, out, mirror, state, flow.fields, flow.gain);
      flow.sweep();
    }
    double worst = 0;
    for (int x = 0; x < nx; ++x) worst = std::max(worst, std::abs(flow.at(x, 2).ux - U) / U);
    return worst;
  };
  EXPECT_LT(run(400), 0.2);  // a pressure side sends all of it back; what is left here is the pressure on its way down
  EXPECT_LT(run(8000), 1e-4);
  EXPECT_LT(std::abs(flow.at(nx / 2, 2).rho), 1e-4 * 3 * U / std::sqrt(3.0));
}

TEST(Outflow, LivesWhereASlidingWallMeetsIt) {
  for (const double speed : {1e-6, 0.1}) {
    Channel channel(Collision::trt, Side::right, 40, 10);
    const BoundaryLinks lid = channel.side(Side::top);
    channel.run_to_rest(1e-9, [&] {
      channel.hold_pressure(channel.in, channel.in_mirror, 0);
      dress_velocity(channel.flow.exec, channel.flow.nodes, lid, {speed, 0}, channel.flow.fields, channel.flow.gain);
      channel.let_out();
    });
    double error = 0;
    for (int along = 0; along < 40; ++along)
      for (int y = 0; y < 10; ++y) error = std::max(error, std::abs(channel.at(along, y).ux / speed - (y + 0.5) / 10));
    std::printf("    Couette flow through open sides at %g: error %.2e\n", speed, error);
    EXPECT_LT(error, 0.01);
  }
}

}  // namespace
}  // namespace vug
