// Conjugate heat against analytic solutions: order and error.
#include "support/heat_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vug {
namespace {

using test::HeatBox;

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
    const double conductivity = c.sigma * c.diffusivity;
    const double contact = 1 / (1 + conductivity);  // fluid wall 1, solid wall 0, layers of equal width
    const auto exact = [&](int x) {
      const double at = x + 0.5;
      return at < n ? 1 - (1 - contact) * at / n : contact * (2 * n - at) / n;
    };
    HeatBox<double> box(
        2 * n, 2, {0.2, 0.2 * c.diffusivity, c.sigma}, [&](int x, int) { return x >= n; },
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
ModeResult decay(const TwoLayerMode& mode, int n) {
  const double dx = 0.5 / n;
  HeatBox<double> box(
      2 * n, 2, {mode.d_f, mode.d_s, mode.sigma}, [&](int x, int) { return x >= n; },
      [&](int x, int) { return mode((x + 0.5) * dx); }, {false, true});
  const double before = box.energy();
  double scale = 0, largest = 0, error = 0;
  for (int x = 0; x < 2 * n; ++x) {
    const double start = std::abs(mode((x + 0.5) * dx));
    scale += 2 * (x < n ? 1 : mode.sigma) * start;
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
    const TwoLayerMode mode(0.14 / std::max(1.0, ratio), 0.14 * std::min(1.0, ratio), c.sigma);
    const ModeResult coarse = decay(mode, 8), medium = decay(mode, 16), fine = decay(mode, 32);
    SCOPED_TRACE(::testing::Message() << "sigma " << c.sigma << " conductivity " << c.conductivity << ": "
                                      << coarse.error << " " << medium.error << " " << fine.error);
    if (std::getenv("VUG_PRINT"))
      std::printf("%g %g: %.3e %.3e %.3e order %.3f %.3f drift %.1e\n", c.sigma, c.conductivity, coarse.error,
                  medium.error, fine.error, std::log2(coarse.error / medium.error),
                  std::log2(medium.error / fine.error), fine.drift);
    EXPECT_GE(std::log2(medium.error / fine.error), 1.95);
    EXPECT_LE(fine.error, c.bound);
    EXPECT_LE(fine.drift, 1e-12);
  }
}

}  // namespace
}  // namespace vug
