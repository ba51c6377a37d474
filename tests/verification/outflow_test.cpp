// What an outflow does to the flow that meets it.
#include "support/record.hpp"
#include "verification/open_channel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

/// A Gaussian vortex of radius 8 that a uniform flow U carries along.
Flow<double> carried_vortex(int nx, double speed, double U) {
  constexpr int ny = 64;
  constexpr double R = 8;
  Flow<double> flow(nx, ny, {false, true}, Collision::trt, 0.53);
  flow.set([&](int x, int y) {
    const double dx = x - 50, dy = y - 32.3, r2 = (dx * dx + dy * dy) / (R * R);
    const double turn = speed * std::exp(0.5 * (1 - r2)) / R;
    return Macroscopic<double>{-1.5 * speed * speed * std::exp(1 - r2), U - turn * dy, turn * dx};
  });
  return flow;
}

TEST(Outflow, AVortexLeavesWithoutAnEcho) {
  // against the same vortex in a lattice twice as long: what the outflow sends back is the energy of the difference
  constexpr int nx = 100;
  constexpr double U = 0.05;
  for (const double speed : {0.2 * U, 0.5 * U, U}) {
    Flow<double> near = carried_vortex(nx, speed, U), far = carried_vortex(2 * nx, speed, U);
    double echo = 0, energy = 0, left = 0;
    const auto settings = [U](Flow<double>& flow) {
      const BoundaryLinks out = flow.side(Side::right);
      OutflowState state;
      fit_to_links(flow.exec, out, state);
      Kokkos::deep_copy(Kokkos::subview(state.level, 0), U);
      return std::tuple(flow.side(Side::left), out, flow.mirror(out), state);
    };
    const auto of_near = settings(near), of_far = settings(far);
    const auto index_near = test::host_copy(near.nodes.index), index_far = test::host_copy(far.nodes.index);
    for (int t = 0; t <= 2000; ++t) {
      if (t % 100 == 0) {
        const auto a = test::host_copy(near.fields.u), b = test::host_copy(far.fields.u);
        double difference = 0;
        left = 0;
        for (int y = 0; y < near.lattice.ny; ++y)
          for (int x = 0; x < nx; ++x) {
            const int i = index_near(near.lattice.node(x, y)), j = index_far(far.lattice.node(x, y));
            difference += std::pow(a(i, 0) - b(j, 0), 2) + std::pow(a(i, 1) - b(j, 1), 2);
            left += std::pow(a(i, 0) - U, 2) + std::pow(a(i, 1), 2);
          }
        if (t == 0) energy = left;
        echo = std::max(echo, difference / energy);
      }
      for (auto* flow : {&near, &far}) {
        const auto& [in, out, mirror, state] = flow == &near ? of_near : of_far;
        dress_velocity(flow->exec, flow->nodes, in, {U, 0}, flow->fields, flow->gain);
        dress_outflow(flow->exec, flow->nodes, out, mirror, state, flow->fields, flow->gain);
        flow->sweep();
      }
    }
    std::printf("    vortex of %.1f U: %.2e of its energy comes back, %.2e is left\n", speed / U, echo, left / energy);
    record("flow_outflow_vortex", {{"speed", speed / U}, {"echo", echo}, {"left", left / energy}});
    EXPECT_LT(echo, 0.025 * std::pow(speed / U, 2));  // as the pressure in its core
    EXPECT_LT(left / energy, 0.001);
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
  fit_to_links(flow.exec, out, state);
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
