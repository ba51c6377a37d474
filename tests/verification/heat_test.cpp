// Conjugate heat in rock and fluid at rest against analytic solutions: order and error.
#include "kernels/heat/heat_kernels.hpp"
#include "support/heat_box.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vug {
namespace {

using test::HeatBox;
using test::record;
using test::velocity_sets;

/// The first root of f above 0, f(0+) > 0, looked for in steps of `step` and bisected.
double first_root(const std::function<double(double)>& f, double step) {
  double high = step;
  while (f(high) > 0) high += step;
  double low = high - step;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

TEST(TwoSlabs, CarryTheSameFluxExactlyInTheSteadyState) {
  const int n = 5;
  struct Contrast {
    double sigma, diffusivity;  // solid over fluid
  };
  for (const Contrast c : {Contrast{1, 1}, {0.625, 2.5}, {10, 1}, {100, 1}, {0.01, 1}, {100, 0.1}, {1, 10}}) {
    const ScalarVelocitySet set = c.sigma == 10 ? ScalarVelocitySet::d2q9 : ScalarVelocitySet::d2q5;
    const double conductivity = c.sigma * c.diffusivity;
    const double contact = 1 / (1 + conductivity);  // fluid wall 1, solid wall 0, layers of equal width
    const auto exact = [&](int x) {
      const double at = x + 0.5;
      return at < n ? 1 - (1 - contact) * at / n : contact * (2 * n - at) / n;
    };
    HeatBox<double> box(
        2 * n, 2, {0.2, 0.2 * c.diffusivity, c.sigma, set}, [&](int x, int) { return x >= n; },
        [&](int x, int y) { return exact(x) + 0.1 * std::sin(x + y); }, {false, true});
    box.side(Side::left, HeatCondition::temperature, 1);
    box.side(Side::right, HeatCondition::temperature, 0);
    box.run(20000);  // more than 40 times n^2 / (pi^2 D / 4) in the slower layer
    const std::vector<double> theta = box.theta();
    // walls and interface lie half way between nodes, where the piecewise linear profile is exact: round-off remains
    for (int x = 0; x < 2 * n; ++x)
      EXPECT_NEAR(theta[x], exact(x), 1e-12) << "sigma " << c.sigma << " diffusivity " << c.diffusivity;
  }
}

/// Slowest decaying mode of two insulated layers of width 1/2, fluid left: cosines of equal decay rate on both sides.
struct TwoLayerMode {
  double d_f, d_s, sigma, rate, k_f, k_s, ratio;
  TwoLayerMode(double d_f_, double d_s_, double sigma_) : d_f(d_f_), d_s(d_s_), sigma(sigma_) {
    const auto mismatch = [&](double m) {
      const double a = std::sqrt(m / d_f) / 2, b = std::sqrt(m / d_s) / 2;
      return std::sqrt(d_f) * std::sin(a) * std::cos(b) + sigma * std::sqrt(d_s) * std::sin(b) * std::cos(a);
    };
    rate = first_root(mismatch, 0.01 * std::min(d_f, d_s));
    k_f = std::sqrt(rate / d_f);
    k_s = std::sqrt(rate / d_s);
    ratio = std::abs(std::cos(k_s / 2)) > 1e-8
                ? std::cos(k_f / 2) / std::cos(k_s / 2)
                : -d_f * k_f * std::sin(k_f / 2) / (sigma * d_s * k_s * std::sin(k_s / 2));
  }
  double operator()(double x) const { return x < 0.5 ? std::cos(k_f * x) : ratio * std::cos(k_s * (1 - x)); }
};

struct ModeResult {
  double error, drift;
};

/// Runs the mode on n nodes per layer until it should have decayed to 1/e; diffusivities are those of the lattice.
ModeResult decay(const TwoLayerMode& mode, int n, ScalarVelocitySet set) {
  const double dx = 0.5 / n;
  HeatBox<double> box(
      2 * n, 1, {mode.d_f, mode.d_s, mode.sigma, set}, [&](int x, int) { return x >= n; },
      [&](int x, int) { return mode((x + 0.5) * dx); }, {false, true});
  const double before = box.energy();
  double scale = 0, largest = 0, error = 0;
  for (int x = 0; x < 2 * n; ++x) {
    const double start = std::abs(mode((x + 0.5) * dx));
    scale += (x < n ? 1 : mode.sigma) * start;
    largest = std::max(largest, start);
  }
  const int steps = static_cast<int>(std::lround(1 / (mode.rate * dx * dx)));
  box.run(steps);
  const double left = std::exp(-mode.rate * dx * dx * steps);
  const std::vector<double> theta = box.theta();
  for (int x = 0; x < 2 * n; ++x) error = std::max(error, std::abs(theta[x] - left * mode((x + 0.5) * dx)));
  return {error / (left * largest), std::abs(box.energy() - before) / scale};
}

TEST(TwoLayerEigenmode, DecaysWithSecondOrderAtAnyContrast) {
  struct Contrast {
    double sigma, conductivity, bound;  // bound: relative Linf error at 32 nodes a layer
  };
  // The error of second-order conduction over a layer of n nodes is (k dx)^2 times a factor of order one, k dx = pi /
  // 64 in the layer that decays: 2.4e-3; the link must not add more than the bulk scheme has.
  constexpr double bulk = 2.4e-3;
  for (const Contrast c : {Contrast{0.625, 1.5625, bulk},
                           {10, 1, bulk},
                           {1e3, 10, bulk},
                           {1e3, 1e3, bulk},
                           {0.01, 1, bulk},
                           {0.01, 0.01, bulk},
                           {100, 0.1, bulk}}) {
    const double ratio = c.conductivity / c.sigma;  // of the diffusivities; the larger one is 0.14
    const TwoLayerMode mode(0.1 / std::max(1.0, ratio), 0.1 * std::min(1.0, ratio), c.sigma);
    for (const ScalarVelocitySet set : velocity_sets) {
      // in one dimension both are the same three velocities: one contrast shows it
      if (set == ScalarVelocitySet::d2q9 && c.sigma != 10) continue;
      const ModeResult coarse = decay(mode, 8, set), medium = decay(mode, 16, set), fine = decay(mode, 32, set);
      SCOPED_TRACE(::testing::Message() << test::name_of(set) << " sigma " << c.sigma << " conductivity "
                                        << c.conductivity << ": " << coarse.error << " " << medium.error << " "
                                        << fine.error);
      const double order = std::log2(medium.error / fine.error);
      EXPECT_GE(order, 1.95);
      EXPECT_LE(fine.error, c.bound);
      EXPECT_LE(fine.drift, 1e-12);
      record("heat_two_layer_mode", {{"set", test::name_of(set)},
                                     {"sigma", c.sigma},
                                     {"conductivity", c.conductivity},
                                     {"error_8", coarse.error},
                                     {"error_16", medium.error},
                                     {"error_32", fine.error},
                                     {"order", order},
                                     {"drift", fine.drift}});
    }
  }
}

/// Two half-spaces brought into contact take the temperature (e_f T_f + e_s T_s) / (e_f + e_s) at once and for ever,
/// e = sqrt(lambda rho cp): a wrong ratio of heat capacities shows here and nowhere in a steady state.
TEST(TwoHalfSpaces, MeetAtTheContactTemperature) {
  struct Contrast {
    double sigma, diffusivity;
  };
  for (const Contrast c : {Contrast{0.625, 2.5}, {10, 1}, {0.1, 1}, {1, 10}, {1, 0.1}, {100, 0.2}, {0.01, 5}}) {
    const int n = 160;
    // both sets are the same in one dimension: one contrast shows it
    const ScalarVelocitySet set = c.sigma == 10 ? ScalarVelocitySet::d2q9 : ScalarVelocitySet::d2q5;
    const double d_f = 0.1 / std::max(1.0, c.diffusivity), d_s = d_f * c.diffusivity;
    HeatBox<double> box(
        2 * n, 1, {d_f, d_s, c.sigma, set}, [&](int x, int) { return x >= n; },
        [&](int x, int) { return x >= n ? 1.0 : 0.0; }, {false, true});
    const double e_f = std::sqrt(d_f), e_s = c.sigma * std::sqrt(d_s), exact = e_s / (e_f + e_s);
    int time = 0;
    for (const int steps : {4000, 6000}) {  // fronts of 2 sqrt(D t) = 13 to 63 nodes: resolved, and far from the ends
      box.run(steps);
      time += steps;
      const std::vector<double> theta = box.theta();
      const double l_f = d_f, l_s = c.sigma * d_s;  // conductivities: both half-links carry the same flux
      const double contact = (l_f * theta[n - 1] + l_s * theta[n]) / (l_f + l_s);
      EXPECT_NEAR(contact, exact, 0.005) << "sigma " << c.sigma << " diffusivity " << c.diffusivity;
      record("heat_half_spaces_contact", {{"set", test::name_of(set)},
                                          {"sigma", c.sigma},
                                          {"diffusivity", c.diffusivity},
                                          {"steps", time},
                                          {"measured", contact},
                                          {"exact", exact}});
      if (c.sigma != 0.625 && c.sigma != 10) continue;
      for (int x = n - 80; x < n + 80; x += 4)
        record(
            "heat_half_spaces_profile",
            {{"sigma", c.sigma}, {"d_f", d_f}, {"d_s", d_s}, {"steps", time}, {"x", x + 0.5 - n}, {"theta", theta[x]}});
    }
  }
}

/// Heat every n lattice steps, diffusivities times n: the same field up to the time error of the scheme.
TEST(HeatInterval, KeepsTheFieldWhenStepsAreLonger) {
  const auto run = [](int interval) {
    HeatBox<double> box(
        48, 24, {0.05 * interval, 0.12 * interval, 0.625}, [](int x, int y) { return x > 20 + y % 5; },
        [](int x, int) { return x > 20 ? 1.0 : 0.0; });
    box.run(800 / interval);
    return box.theta();
  };
  const std::vector<double> reference = run(1);
  for (const auto& [interval, bound] : {std::pair{2, 0.002}, {4, 0.01}}) {
    const std::vector<double> longer = run(interval);
    double error = 0;
    for (std::size_t i = 0; i < longer.size(); ++i) error = std::max(error, std::abs(longer[i] - reference[i]));
    // 3 D^2 (k dx)^2 with k dx = 1 / sqrt(4 D t) = 0.05: far below; the start, a jump, adds a step's worth of lag
    EXPECT_LE(error, bound);
  }
}

}  // namespace
}  // namespace vug
