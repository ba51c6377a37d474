// Channels between pressures, over their whole length: what an open side does to the flow that meets it.
#include "verification/open_channel.hpp"

#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug {
namespace {

using namespace test::open_channel;
using test::record;

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

}  // namespace
}  // namespace vug
