// Channels between open sides, over their whole length: what a pressure and an outflow do to the flow that meets them.
#include "kernels/flow/guards.hpp"
#include "kernels/nodes/side_links.hpp"
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug {
namespace {

using test::Flow;
using test::record;

constexpr Collision collisions[] = {Collision::trt, Collision::lallemand_luo, Collision::bgk, Collision::regularised};
constexpr const char* names[] = {"trt", "lallemand_luo", "bgk", "regularised"};
constexpr double tau = 0.764, nu = (tau - 0.5) / 3;

/// A channel of `width` cells between walls, `length` cells from its inlet to its outlet, which may be any side.
struct Channel {
  Side outlet;
  int length, width;
  Flow<double> flow;
  BoundaryLinks in, out;
  IndexList in_mirror, out_mirror;
  OutflowState outflow;

  Channel(Collision collision, Side outlet_side, int cells_along, int cells_across)
      : outlet(outlet_side),
        length(cells_along),
        width(cells_across),
        flow(upright() ? width : length, upright() ? length : width, {false, false}, collision, tau),
        in(side(inlet())),
        out(side(outlet)),
        in_mirror(flow.mirror(in)),
        out_mirror(flow.mirror(out)) {
    fit_to_links(flow.exec, out, outflow);
  }
  Side inlet() const { return static_cast<Side>(D2Q9::opposite(static_cast<int>(outlet))); }
  /// The links out of corners belong to the walls, or to the inlet if it is `fed`: as in a case.
  BoundaryLinks side(Side which, bool fed = false) const {
    const Side wall = upright() ? Side::left : Side::bottom, other = upright() ? Side::right : Side::top;
    const SideOrder order = fed ? SideOrder{inlet(), wall, other, outlet} : SideOrder{wall, other, inlet(), outlet};
    const bool end = which == inlet() || which == outlet;
    return find_boundary_links(flow.exec, flow.nodes, which, 0, (end ? width : length) - 1, D2Q9::Q, order);
  }
  bool upright() const { return outlet == Side::top || outlet == Side::bottom; }
  bool backwards() const { return outlet == Side::left || outlet == Side::bottom; }
  /// Density, speed along and across the channel `along` cells from the inlet.
  Macroscopic<double> at(int along, int across) const {
    const int s = backwards() ? length - 1 - along : along;
    const Macroscopic<double> m = upright() ? flow.at(across, s) : flow.at(s, across);
    const double sign = backwards() ? -1 : 1;
    return {m.rho, sign * (upright() ? m.uy : m.ux), upright() ? m.ux : m.uy};
  }
  /// Everything at once: row `along` * width + across.
  std::vector<Macroscopic<double>> fields() const {
    const auto density = test::host_copy(densities(flow.exec, flow.nodes, flow.fields));
    const auto u = test::host_copy(flow.fields.u);
    const auto index = test::host_copy(flow.nodes.index);
    std::vector<Macroscopic<double>> all;
    for (int along = 0; along < length; ++along)
      for (int across = 0; across < width; ++across) {
        const int s = backwards() ? length - 1 - along : along, sign = backwards() ? -1 : 1;
        const int i = index(upright() ? flow.lattice.node(across, s) : flow.lattice.node(s, across));
        all.push_back({density(i), sign * u(i, upright() ? 1 : 0), u(i, upright() ? 0 : 1)});
      }
    return all;
  }
  std::array<double, 2> towards_outlet(double speed) const {
    const int q = static_cast<int>(outlet);
    return {speed * D2Q9::c(q, 0), speed * D2Q9::c(q, 1)};
  }
  /// Steps (with `dress` before each) until the largest change of velocity in 200 steps is `tolerance` of the largest.
  template <class Dress>
  void run_to_rest(double tolerance, const Dress& dress) {
    const VectorField<double> previous("previous", flow.nodes.capacity);
    for (int t = 0; t < 200'000; t += 200) {
      for (int k = 0; k < 200; ++k) {
        dress();
        flow.sweep();
      }
      if (velocity_change(flow.exec, flow.nodes, flow.fields.u, previous) <= tolerance) return;
    }
    FAIL() << "the flow did not become steady";
  }
  void hold_pressure(const BoundaryLinks& side, const IndexList& mirror, double p) {
    dress_pressure(flow.exec, flow.nodes, side, mirror, p, flow.fields, flow.gain);
  }
  /// Every link through the open sides its own image: anti-bounce-back, which leaves the shear along them free.
  void forget_mirrors() {
    for (const IndexList& mirror : {in_mirror, out_mirror}) {
      const auto own = Kokkos::create_mirror_view(mirror);
      std::iota(own.data(), own.data() + own.extent(0), 0);
      Kokkos::deep_copy(mirror, own);
    }
  }
  void let_out() { dress_outflow(flow.exec, flow.nodes, out, out_mirror, outflow, flow.fields, flow.gain); }
};

/// What every node of the scheme has for a pressure gradient: the parabola and the slip of halfway bounce-back
/// (Ginzburg and d'Humieres), which is none with two relaxation times.
double node_speed(Collision collision, double gradient, int width, int across) {
  const RelaxationRates r = relaxation_rates(collision, tau);
  const double lambda = (1 / r.s_nu - 0.5) * (1 / r.s_q - 0.5), y = across + 0.5;
  return gradient / (2 * nu) * (y * (width - y) + 4 * lambda / 3 - 0.25);
}

struct ChannelErrors {
  double field, pressure, along_side, flow_rate;
};

/// A channel of length 4 H between two pressures, creeping: largest errors over all nodes from side to side of velocity
/// (over the mean) and pressure (over the difference applied), speed along the sides, and the flow rate against
/// G H^3 / (12 nu).
ChannelErrors between_pressures(Collision collision, Side outlet, int width, bool mirrored = true) {
  const int length = 4 * width;
  const double mean = 1e-9, gradient = 12 * nu * mean / (width * width), applied = gradient * length;
  Channel channel(collision, outlet, length, width);
  if (!mirrored) channel.forget_mirrors();
  channel.run_to_rest(1e-9, [&] {
    channel.hold_pressure(channel.in, channel.in_mirror, applied);
    channel.hold_pressure(channel.out, channel.out_mirror, 0);
  });
  ChannelErrors errors{};
  const auto fields = channel.fields();
  double flow_rate = 0;
  for (int along = 0; along < length; ++along)
    for (int across = 0; across < width; ++across) {
      const Macroscopic<double> m = fields[along * width + across];
      const double speed = node_speed(collision, gradient, width, across);
      errors.field = std::max({errors.field, std::abs(m.ux - speed) / mean, std::abs(m.uy) / mean});
      errors.pressure = std::max(errors.pressure, std::abs(m.rho / 3 - gradient * (length - along - 0.5)) / applied);
      if (along == 0 || along == length - 1) errors.along_side = std::max(errors.along_side, std::abs(m.uy) / mean);
      if (along == length / 2) flow_rate += m.ux;
    }
  errors.flow_rate = flow_rate / width / mean - 1;
  return errors;
}

TEST(PressureDrivenChannel, CarriesPoiseuilleFromSideToSideInEveryDirectionAndCollision) {
  for (const Side outlet : all_sides)
    for (int c = 0; c < 4; ++c) {
      const ChannelErrors errors = between_pressures(collisions[c], outlet, 5);
      EXPECT_LT(errors.field, 1e-6) << names[c] << " to the " << name_of(outlet);
      EXPECT_LT(errors.pressure, 1e-6) << names[c] << " to the " << name_of(outlet);
    }
}

/// The rate of what halfway bounce-back makes of the parabola: its slip, and the sum over cells in place of the
/// integral, 1/(2 n^2), together (8 Lambda - 1)/n^2. The sides add nothing.
void flow_rate_of_the_nodes(Collision collision, const char* name, int n) {
  const ChannelErrors errors = between_pressures(collision, Side::right, n);
  record("flow_pressure_channel", {{"rule", "mirror"},
                                   {"collision", name},
                                   {"n", n},
                                   {"flow_rate", errors.flow_rate},
                                   {"field", errors.field},
                                   {"along_side", errors.along_side}});
  const RelaxationRates r = relaxation_rates(collision, tau);
  const double lambda = (1 / r.s_nu - 0.5) * (1 / r.s_q - 0.5);
  EXPECT_NEAR(errors.flow_rate * n * n, 8 * lambda - 1, 1e-5 * n * n) << name << " " << n;
  EXPECT_LT(errors.field, 1e-5) << name << " " << n;
  EXPECT_LT(errors.along_side, 1e-5) << name << " " << n;
}

TEST(PressureDrivenChannel, FlowRateConvergesWithSecondOrderInEveryCollision) {
  for (int c = 0; c < 4; ++c)
    for (const int n : {3, 5, 9, 10, 20}) flow_rate_of_the_nodes(collisions[c], names[c], n);
}

TEST(PressureDrivenChannelLong, FlowRateConvergesWithSecondOrderInEveryCollision) {
  for (int c = 0; c < 4; ++c) flow_rate_of_the_nodes(collisions[c], names[c], 40);
}

/// What the mirror image is for.
void flow_rate_without_mirror(int n) {
  const ChannelErrors errors = between_pressures(Collision::trt, Side::right, n, false);
  record("flow_pressure_channel", {{"rule", "itself"},
                                   {"collision", "trt"},
                                   {"n", n},
                                   {"flow_rate", errors.flow_rate},
                                   {"field", errors.field},
                                   {"along_side", errors.along_side}});
  EXPECT_GT(errors.flow_rate, 0.02) << n;
  if (n >= 10) {
    EXPECT_GT(errors.along_side, 0.1) << n;
  }
}

TEST(PressureDrivenChannel, CarriesTooMuchOnAnyLatticeWhereEachLinkIsItsOwnImage) {
  for (const int n : {3, 5, 9, 10, 20}) flow_rate_without_mirror(n);
}

TEST(PressureDrivenChannelLong, CarriesTooMuchOnAnyLatticeWhereEachLinkIsItsOwnImage) {
  flow_rate_without_mirror(40);
}

/// At the speeds of a run the quadratic terms of the equilibrium reach the side: as the speed, over the width squared.
TEST(PressureDrivenChannel, KeepsItsProfileWithInertia) {
  constexpr int width = 10, length = 4 * width;
  constexpr double mean = 0.01, gradient = 12 * nu * mean / (width * width);
  Channel channel(Collision::trt, Side::right, length, width);
  channel.run_to_rest(1e-8, [&] {
    channel.hold_pressure(channel.in, channel.in_mirror, gradient * length);
    channel.hold_pressure(channel.out, channel.out_mirror, 0);
  });
  for (int across = 0; across < width; ++across)
    for (int along = 0; along < length; ++along) {
      const Macroscopic<double> m = channel.at(along, across);
      EXPECT_NEAR(m.ux / mean, node_speed(Collision::trt, gradient, width, across) / mean, 5e-4);
      EXPECT_NEAR(m.uy / mean, 0, 1e-3);
    }
}

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
