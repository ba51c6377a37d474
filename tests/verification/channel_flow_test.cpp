// Plane channels: the solutions that halfway bounce-back with two relaxation times represents exactly.
#include "kernels/flow/guards.hpp"
#include "support/dress_one.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug {
namespace {

using test::Flow;
using test::record;

/// Sweeps (with `dress` before each) until the velocity no longer changes, and fails when it does not get there.
template <class Dress>
void run_to_rest(Flow<double>& flow, double tolerance, const Dress& dress) {
  constexpr int interval = 200;
  std::vector<double> last(2 * static_cast<std::size_t>(flow.nodes.count));
  for (int t = 0; t < 2'000'000; t += interval) {
    for (int k = 0; k < interval; ++k) {
      dress();
      flow.sweep();
    }
    const auto u = test::host_copy(flow.fields.u);
    double change = 0, size = 0;
    for (int i = 0; i < flow.nodes.count; ++i)
      for (int axis = 0; axis < 2; ++axis) {
        change = std::max(change, std::abs(u(i, axis) - last[2 * i + axis]));
        size = std::max(size, std::abs(u(i, axis)));
        last[2 * i + axis] = u(i, axis);
      }
    if (change <= tolerance * size) return;
  }
  FAIL() << "the flow did not become steady";
}

/// A channel of n nodes to be driven by a body force along x (axis 0) or y (axis 1) to the given speed in its middle.
template <class T>
Flow<T> driven_channel(Collision collision, int n, double tau, int axis, double top_speed) {
  Flow<T> flow(axis == 0 ? 2 : n, axis == 0 ? n : 2, {axis == 0, axis == 1}, collision, tau);
  flow.step.body_force[axis] = static_cast<T>(8 * (tau - 0.5) / 3 * top_speed / (n * n));
  return flow;
}

/// Relative L2 error of its velocity.
template <class T>
double parabola_error(const Flow<T>& flow, int n, int axis, double top_speed) {
  double error2 = 0, size2 = 0;
  for (int k = 0; k < n; ++k) {
    const double y = k + 0.5, exact = 4 * top_speed * y * (n - y) / (n * n);
    const Macroscopic<double> m = axis == 0 ? flow.at(1, k) : flow.at(k, 1);
    error2 += std::pow((axis == 0 ? m.ux : m.uy) - exact, 2) + std::pow(axis == 0 ? m.uy : m.ux, 2);
    size2 += exact * exact;
  }
  return std::sqrt(error2 / size2);
}

double poiseuille_error(Collision collision, int n, double tau, int axis) {
  Flow<double> flow = driven_channel<double>(collision, n, tau, axis, 0.01);
  run_to_rest(flow, 1e-15, [] {});
  return parabola_error(flow, n, axis, 0.01);
}

TEST(Poiseuille, ExactAtAnyWidthAndViscosityWithTwoRelaxationTimes) {
  // round-off only: the magic product 3/16 puts the no-slip plane exactly half way (1e-15 per step, amplified by the
  // number of steps a wide viscous channel takes)
  for (const int n : {1, 3, 5, 9, 17})
    for (const double tau : {0.55, 0.764, 1.0, 2.0, 5.0}) {
      const double error = poiseuille_error(Collision::trt, n, tau, 0);
      EXPECT_LT(error, 1e-12) << n << " nodes, tau " << tau;
      record("flow_poiseuille", {{"n", n}, {"tau", tau}, {"error", error}});
    }
}

TEST(Poiseuille, FloatKeepsItsDigitsAtAnySpeed) {
  // Populations are deviations from rest, so that rounding is relative to the flow and a creeping flow has the digits
  // of a fast one: 6e-8 per operation, and the steady state remembers what n^2 / nu steps have rounded, of which a
  // fifth is allowed to point the same way. Of a node alone between two walls all comes back at once, and roundings
  // that nothing averages add up to eleven.
  for (const double top_speed : {0.01, 1e-6, 1e-12})
    for (const int n : {1, 3, 9, 17})
      for (const double tau : {0.55, 0.764, 2.0}) {
        Flow<float> flow = driven_channel<float>(Collision::trt, n, tau, 0, top_speed);
        const int steps = 300 + static_cast<int>(2 * n * n / ((tau - 0.5) / 3));  // the slowest mode decays to 2e-9
        for (int t = 0; t < steps; ++t) flow.sweep();
        const double error = parabola_error(flow, n, 0, top_speed);
        EXPECT_LT(error, 6e-8 * ((n == 1 ? 12 : 3) + 0.2 * n * n / ((tau - 0.5) / 3)))
            << n << " nodes, tau " << tau << ", speed " << top_speed;
        record("flow_poiseuille_float", {{"n", n}, {"tau", tau}, {"speed", top_speed}, {"error", error}});
      }
}

/// The force that drives a wide channel is small, 8 nu u/n^2, and so must be what a collision takes of the momentum.
/// From rest, because rounding to the nearest number also holds a flow where it is.
TEST(Poiseuille, FloatBringsAWideChannelToItsSpeed) {
  const int n = 64;
  const double tau = 0.56, top_speed = 0.05, spread = n * n / ((tau - 0.5) / 3);
  const auto mean = [&](const auto& flow) {
    double sum = 0;
    for (int k = 0; k < n; ++k) sum += flow.at(1, k).ux;
    return sum / n;
  };
  for (const Collision c : {Collision::trt, Collision::lallemand_luo, Collision::bgk}) {
    Flow<float> flow = driven_channel<float>(c, n, tau, 0, top_speed);
    for (int t = 0; t < 1.5 * spread; ++t) flow.sweep();  // what is left falls to 4e-7
    Flow<double> same = driven_channel<double>(c, n, tau, 0, top_speed);
    same.set([&](int, int y) {
      return Macroscopic<double>{0, 4 * top_speed * (y + 0.5) * (n - y - 0.5) / (n * n), 0};
    });
    for (int t = 0; t < 0.3 * spread; ++t) same.sweep();
    const double error = mean(flow) / mean(same) - 1;
    record("flow_wide_channel_float", {{"collision", static_cast<int>(c)}, {"error", error}});
    EXPECT_LT(std::abs(error), 5e-4) << static_cast<int>(c);  // two rates: 1.8e-3 by rounded weights and rates
  }
}

/// 1 + (8 Lambda - 1)/n^2 of what flows between plates, 2/3 of the largest speed in the mean.
TEST(Poiseuille, FewRowsCarryWhatTheCollisionLetsThrough) {
  constexpr double tau = 0.8, top_speed = 0.01;
  for (const Collision c : {Collision::trt, Collision::bgk, Collision::lallemand_luo, Collision::regularised})
    for (const int n : {1, 2, 3}) {
      Flow<double> flow = driven_channel<double>(c, n, tau, 0, top_speed);
      run_to_rest(flow, 1e-15, [] {});
      double sum = 0;
      for (int y = 0; y < n; ++y) sum += flow.at(1, y).ux;
      const double carried = sum / n / (2 * top_speed / 3);
      const double expected = carried_by_rows(n, wall_magic(relaxation_rates(c, tau)));
      record("flow_few_rows",
             {{"collision", static_cast<int>(c)}, {"n", n}, {"carried", carried}, {"expected", expected}});
      EXPECT_NEAR(carried, expected, 1e-9) << "collision " << static_cast<int>(c) << ", " << n << " rows";
    }
}

TEST(Poiseuille, TheSameAlongTheOtherAxis) {
  for (const double tau : {0.55, 0.764, 5.0})
    EXPECT_LT(poiseuille_error(Collision::trt, 5, tau, 1), 1e-12) << "tau " << tau;
}

TEST(Poiseuille, OtherCollisionsSlipAsTheoryPredictsAndConverge) {
  // With the product Lambda the profile is the exact parabola plus a constant slip of F/(2 nu) (4 Lambda/3 - 1/4)
  // (Ginzburg and d'Humieres): second order in 1/n.
  const double tau = 0.764;
  for (const Collision c : {Collision::bgk, Collision::lallemand_luo}) {
    const double lambda = wall_magic(relaxation_rates(c, tau));
    std::array<double, 2> error;
    for (const int n : {3, 5, 9, 17})
      record("flow_poiseuille_slip", {{"collision", c == Collision::bgk ? "bgk" : "lallemand_luo"},
                                      {"n", n},
                                      {"error", poiseuille_error(c, n, tau, 0)}});
    for (const int n : {5, 17}) {
      double size2 = 0;
      const double scale = 0.04 / (n * n);  // F/(2 nu) of poiseuille_error
      for (int k = 0; k < n; ++k) size2 += std::pow(scale * (k + 0.5) * (n - k - 0.5), 2);
      const double expected = std::abs(scale * (4 * lambda / 3 - 0.25)) * std::sqrt(n / size2);
      error[n == 17] = poiseuille_error(c, n, tau, 0);
      EXPECT_NEAR(error[n == 17], expected, 1e-10 * expected + 1e-12) << n;
    }
    EXPECT_NEAR(std::log(error[0] / error[1]) / std::log(17.0 / 5.0), 2, 0.1);
  }
}

/// The profile over a channel of five nodes at the viscosity of the paper, for the page.
TEST(Poiseuille, ProfileOfFiveNodes) {
  for (const Collision c : {Collision::trt, Collision::bgk}) {
    Flow<double> flow = driven_channel<double>(c, 5, 0.764, 0, 0.01);
    run_to_rest(flow, 1e-15, [] {});
    for (int y = 0; y < 5; ++y) {
      const double exact = 4 * (y + 0.5) * (4.5 - y) / 25;
      EXPECT_NEAR(flow.at(1, y).ux / 0.01, exact, c == Collision::trt ? 1e-12 : 0.1);
      record(
          "flow_poiseuille_profile",
          {{"collision", c == Collision::trt ? "trt" : "bgk"}, {"y", (y + 0.5) / 5}, {"u", flow.at(1, y).ux / 0.01}});
    }
  }
}

TEST(Poiseuille, RegularisedConvergesWithSecondOrder) {
  const double coarse = poiseuille_error(Collision::regularised, 5, 0.764, 0);
  const double fine = poiseuille_error(Collision::regularised, 17, 0.764, 0);
  EXPECT_LT(coarse, 0.02);  // measured independently: 0.016
  EXPECT_GT(std::log(coarse / fine) / std::log(17.0 / 5.0), 1.9);
}

TEST(Couette, WallsThatMoveOnAnySideDragTheSameFlow) {
  constexpr int n = 7;
  for (const Side moving : all_sides) {
    const bool upright = is_upright(moving);
    Flow<double> flow(upright ? n : 2, upright ? 2 : n, {!upright, upright}, Collision::trt, 0.764);
    const BoundaryLinks wall = flow.side(moving);
    const std::array<double, 2> speed{upright ? 0 : -0.05, upright ? -0.05 : 0};
    run_to_rest(flow, 1e-15, [&] { dress_velocity(flow.exec, flow.nodes, wall, speed, flow.fields, flow.gain); });
    for (int k = 0; k < n; ++k) {
      const double from_rest = moving == Side::right || moving == Side::top ? k + 0.5 : n - k - 0.5;
      const Macroscopic<double> m = upright ? flow.at(k, 1) : flow.at(1, k);
      EXPECT_NEAR(upright ? m.uy : m.ux, -0.05 * from_rest / n, 1e-14) << vug::name_of(moving);
      EXPECT_NEAR(upright ? m.ux : m.uy, 0, 1e-15) << vug::name_of(moving);
    }
  }
}

TEST(Couette, LinearProfileIsExactInEveryCollision) {
  constexpr int n = 7;
  for (const Collision c : {Collision::trt, Collision::lallemand_luo, Collision::bgk, Collision::regularised}) {
    Flow<double> flow(2, n, {true, false}, c, 0.764);
    const BoundaryLinks top = flow.side(Side::top);
    run_to_rest(flow, 1e-15, [&] { dress_velocity(flow.exec, flow.nodes, top, {0.05, 0}, flow.fields, flow.gain); });
    for (int y = 0; y < n; ++y) {
      EXPECT_NEAR(flow.at(1, y).ux, 0.05 * (y + 0.5) / n, 1e-14) << int(c);
      if (c == Collision::trt) record("flow_couette", {{"y", (y + 0.5) / n}, {"u", flow.at(1, y).ux / 0.05}});
    }
    EXPECT_NEAR(sum_in_order(flow.gain), 0, 1e-13);  // a wall that slides lets nothing in
  }
}

}  // namespace
}  // namespace vug
