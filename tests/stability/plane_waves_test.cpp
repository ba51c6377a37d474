// Von Neumann's analysis against the equations that the schemes stand for, and against what the lattices do.
#include "coupling/plane_waves.hpp"

#include "../reference/reactive_box.hpp"
#include "coupling/heat_module.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace vug {
namespace {

using test::Flow;
using Wave = std::complex<double>;

/// Distance of a number from the nearest of the eigenvalues.
double nearest(const std::vector<Wave>& values, Wave wanted) {
  double least = INFINITY;
  for (const Wave& value : values) least = std::min(least, std::abs(value - wanted));
  return least;
}

/// exp(-i k.u - decay k^2) of one step.
Wave carried(const Vector2& k, const Vector2& u, double decay) {
  return std::exp(Wave(-decay * (k[0] * k[0] + k[1] * k[1]), -(k[0] * u[0] + k[1] * u[1])));
}

TEST(PlaneWaves, LongOnesAreThoseOfTheEquations) {
  const Vector2 u{0.01, 0.004};
  const auto errors = [&](double wave) {
    const Vector2 k{wave * 0.6, wave * 0.8};
    const double modulus = std::hypot(k[0], k[1]);
    std::vector<double> error;
    for (const Collision c : {Collision::trt, Collision::lallemand_luo, Collision::bgk, Collision::regularised}) {
      constexpr double tau = 0.8, nu = (tau - 0.5) / 3;
      const auto values = flow_waves(c, tau, u, k);
      error.push_back(nearest(values, carried(k, u, nu)));
      // Sound is damped by half of the shear and the bulk viscosity. Its speed is not the same to all observers:
      // rho' = 3 p' and j obey w^2 - 2 k.u w - c_s^2 k^2 = 0 in the incompressible form of He and Luo.
      const double bulk = (1 / relaxation_rates(c, tau).s_e - 0.5) / 3, along = k[0] * u[0] + k[1] * u[1];
      for (const double sign : {-1.0, 1.0})
        error.push_back(
            nearest(values, carried(k, u, (nu + bulk) / 2) *
                                std::polar(1.0, sign * std::sqrt(along * along + c_s2 * modulus * modulus))));
    }
    for (const double D : {0.02, 0.3}) {
      error.push_back(nearest(solute_waves<D2Q5>(solute_parameters(D), u, k), carried(k, u, D)));
      error.push_back(nearest(solute_waves<D2Q9>(solute_parameters(D, 0.7), u, k), carried(k, u, D)));
      error.push_back(nearest(heat_waves<D2Q5>(D, u, k), carried(k, u, D)));
      error.push_back(nearest(heat_waves<D2Q9>(D, u, k), carried(k, u, D)));
    }
    return error;
  };
  const auto coarse = errors(0.02), fine = errors(0.01);
  for (std::size_t n = 0; n < coarse.size(); ++n) {
    EXPECT_LT(fine[n], 2e-7) << n;  // of what u^2 (1e-4) does to the diffusivity
    EXPECT_LT(fine[n], coarse[n] / 3.4) << n;
  }
}

/// Growth per step of the deviation from the uniform state, while it grows from 1e-9 to 1e-6.
template <class Step, class Deviation>
double measured_growth(const Step& step, const Deviation& deviation) {
  double before = 0;
  for (int n = 0, start = 0; n < 100000; ++n) {
    step();
    const double now = deviation();
    if (before == 0 && now > 1e-9) {
      before = now;
      start = n;
    }
    if (now > 1e-6) return std::pow(now / before, 1.0 / (n - start));
  }
  ADD_FAILURE() << "nothing grows";
  return 0;
}

/// Of all waves that fit into a box of 24 x 24 nodes.
template <class Values>
double largest_growth(const Values& values_of) {
  double largest = 0;
  for (int x = 0; x < 24; ++x)
    for (int y = 0; y < 24; ++y)
      for (const Wave& value : values_of(Vector2{2 * std::numbers::pi * x / 24, 2 * std::numbers::pi * y / 24}))
        largest = std::max(largest, std::abs(value));
  return largest;
}

double deviation(const VectorField<double>& field, int count, const Vector2& mean) {
  const auto u = test::host_copy(field);
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += std::pow(u(i, 0) - mean[0], 2) + std::pow(u(i, 1) - mean[1], 2);
  return std::sqrt(sum);
}

TEST(PlaneWaves, OfFlowGrowAsOnTheLattice) {
  for (const auto& [collision, tau, u] : {std::tuple{Collision::bgk, 0.501, Vector2{0.25, 0}},
                                          {Collision::trt, 0.502, Vector2{0.2, 0.05}},
                                          {Collision::lallemand_luo, 0.501, Vector2{0.25, 0.1}},
                                          {Collision::regularised, 0.501, Vector2{0.3, 0}}}) {
    Flow<double> flow(24, 24, {true, true}, collision, tau);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(-1e-12, 1e-12);
    flow.set([&](int, int) { return Macroscopic<double>{noise(random), u[0] + noise(random), u[1] + noise(random)}; });
    const double growth =
        measured_growth([&] { flow.sweep(); }, [&] { return deviation(flow.fields.u, flow.nodes.count, u); });
    const double expected = largest_growth([&](const Vector2& k) { return flow_waves(collision, tau, u, k); });
    std::printf("    collision %d, tau %g: grows by %.5f a step, analysis %.5f\n", static_cast<int>(collision), tau,
                growth, expected);
    EXPECT_NEAR((growth - 1) / (expected - 1), 1, 0.05);
    EXPECT_GT(expected, neutral_growth);
  }
}

/// The table of docs/stability.md was measured with noise on a box: the analysis says the same.
TEST(PlaneWaves, OfSolutesAreLostWhereTheLatticeIs) {
  for (const double D : {0.3, 0.03, 0.003, 1e-4})
    for (const double speed : {0.05, 0.2, 0.4})
      EXPECT_LE(solute_wave_growth<D2Q5>(solute_parameters(D), speed), neutral_growth) << D << ' ' << speed;
  struct {
    double D, tau_h, holds, lost;
  } const measured[] = {{0.03, 0.7, 0.3, 0.4}, {0.01, 0.7, 0.2, 0.3}, {0.003, 0.7, 0.15, 0.2}, {0.001, 0.7, 0.1, 0.15}};
  for (const auto& [D, tau_h, holds, lost] : measured) {
    EXPECT_LE(solute_wave_growth<D2Q5>(solute_parameters(D, tau_h), holds), 1.001) << D;
    EXPECT_GT(solute_wave_growth<D2Q5>(solute_parameters(D, tau_h), lost), 1.0005) << D;
  }
}

/// What breaks convection beside walls (docs/stability.md) is the walls' doing.
TEST(PlaneWaves, OfHeatDoNotGrowWithoutWalls) {
  for (const double D : {1.0, 0.05, 0.001, 1e-5})
    for (const double speed : {0.05, 0.2, longest_way}) {
      EXPECT_LE(heat_wave_growth<D2Q5>(D, speed), neutral_growth) << D << ' ' << speed;
      EXPECT_LE(heat_wave_growth<D2Q9>(D, std::min(speed, 0.2)), neutral_growth) << D << ' ' << speed;
    }
  EXPECT_GT(heat_wave_growth<D2Q5>(0.05, 0.6), 1 + 1e-3) << "beyond 1 / sqrt 3";
}

}  // namespace
}  // namespace vug
