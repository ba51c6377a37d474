// Slow changes in single precision, each step of which is below the last place of what it changes: against analytic
// solutions and balances.
#include "../reference/reactive_box.hpp"
#include "kernels/solute/solute_boundary.hpp"
#include "support/heat_box.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace vug {
namespace {

using reference::ReactiveBox;
using test::HeatBox;
using test::record;

/// Change of a slab at depth z (of its thickness) over that of its surface after the Fourier number Fo; no flux through
/// the other side (Carslaw and Jaeger, 3.3).
double slab_change(double z, double Fo) {
  double left = 0;
  for (int n = 60; n >= 0; --n) {
    const double beta = (n + 0.5) * std::numbers::pi;
    left += 2 / beta * std::sin(beta * z) * std::exp(-beta * beta * Fo);
  }
  return 1 - left;
}

/// What random rounding of so many sums adds up to at most, of their last place.
double walk(double sums) {
  return 0.5 * std::sqrt(sums);
}

/// Change of the concentrations along a slab of n cells, from 1, after `steps` with a surface at 1 - below; and what
/// has entered through the surface.
template <class T>
std::pair<std::vector<double>, double> slow_diffusion(int n, double D, double below, int steps) {
  ReactiveBox<D2Q5, T> box(n, 1, [](int, int) { return false; }, solute_parameters(D), 1.0, {false, true});
  box.give_concentration(Side::left, [&](int) { return 1 - below; });
  for (int s = 0; s < steps; ++s) box.step();
  std::vector<double> change = box.concentration(box.acid);
  for (double& C : change) C -= 1;
  return {change, box.gained()};
}

TEST(SinglePrecision, CarriesSlowDiffusionOfASmallDifference) {
  const int n = 100, steps = 400000;
  const double D = 0.001, below = 1e-3;
  const auto [change, entered] = slow_diffusion<float>(n, D, below, steps);
  const auto [change_in_double, entered_in_double] = slow_diffusion<double>(n, D, below, steps);
  double error = 0, off = 0, sum = 0;
  for (int x = 0; x < n; ++x) {
    off = std::max(off, std::abs(change_in_double[x] / below + slab_change((x + 0.5) / n, D * steps / (n * n))));
    error = std::max(error, std::abs(change[x] - change_in_double[x]) / below);
    sum += change[x];
  }
  record("slow_diffusion_error", {{"error", error}});
  EXPECT_LT(off, 1e-4);
  EXPECT_LT(error, 0.1);  // 0.9 when rounded to the nearest
  EXPECT_NEAR(sum, entered, walk(n * steps) * 0x1p-25);
  EXPECT_NEAR(entered, entered_in_double, 0.1 * std::abs(entered_in_double));
}

TEST(SinglePrecision, CarriesSlowConductionOfRockFarFromItsReference) {
  const int n = 100, steps = 200000;
  const double D = 0.002;
  for (const ScalarVelocitySet set : test::velocity_sets) {
    HeatBox<float> box(
        n, 1, {0.1, D, 0.625, set}, [](int, int) { return true; }, [](int, int) { return 200; }, {false, true});
    box.side(Side::left, HeatCondition::temperature, 0);
    box.run(steps);
    const std::vector<double> theta = box.theta();
    double error = 0;
    for (int x = 0; x < n; ++x)
      error = std::max(error, std::abs(theta[x] - 200 * (1 - slab_change((x + 0.5) / n, D * steps / (n * n)))));
    record("slow_conduction_error_K", {{"error", error}});
    EXPECT_LT(error, 0.02);
  }
}

TEST(SinglePrecision, DeliversASmallFlux) {
  const int n = 5, steps = 100000;
  for (const double flux : {1e-8, 5e-9}) {
    ReactiveBox<D2Q5, float> box(n, 1, [](int, int) { return false; }, solute_parameters(0.1), 1.0, {false, true});
    const BoundaryLinks links = find_boundary_links(box.exec, box.nodes, Side::left, 0, 0, D2Q5::Q);
    const ScalarField<double> gain("gain", links.count), area = link_areas(links, D2Q5::Q);
    for (int s = 0; s < steps; ++s) {
      box.acid.rounding = rounding_of_step<float>(s);
      const std::array condition{flux_condition(links, area, flux, box.acid, gain)};
      dress<D2Q5, float>(box.exec, box.nodes, std::span<const SoluteCondition<float>>(condition));
      advance_solute<D2Q5>(box.exec, box.nodes, box.parameters, box.acid);
    }
    EXPECT_NEAR(sum_in_order(gain), steps * flux, 0.01 * steps * flux);
    EXPECT_NEAR(box.acid_total() - n, steps * flux, walk(n * steps) * 0x1p-25);  // 2 % of what enters

    HeatBox<float> rock(
        n, 1, {0.1, 0.1, 0.625, ScalarVelocitySet::d2q5}, [](int, int) { return true; }, [](int, int) { return 100; },
        {false, true});
    rock.side(Side::left, HeatCondition::flux, 100 * flux);
    const double before = rock.energy();
    rock.run(steps);
    EXPECT_NEAR(rock.energy() - before, 100 * steps * flux, walk(n * steps) * 0x1p-18);
  }
}

TEST(SinglePrecision, TakesFromTheFluidWhatASlowWallDissolves) {
  const int n = 20, steps = 50000;
  for (const double k : {1e-8, 2e-9}) {
    ReactiveBox<D2Q5, float> box(n, 3, [](int, int y) { return y != 1; }, solute_parameters(0.1), 1.0, {true, true});
    box.add_product(1.0);
    box.k = k;
    box.wall.product_yield = 1;
    for (int s = 0; s < steps; ++s) box.step();
    const double dissolved = 2 * n * k * steps;  // two walls; the concentration falls by a thousandth
    EXPECT_NEAR(sum_in_order(box.consumed), dissolved, 2e-3 * dissolved);
    EXPECT_NEAR(n - box.acid_total(), dissolved, 5e-3 * dissolved);
    EXPECT_NEAR(box.product_total() - n, dissolved, 5e-3 * dissolved);
  }
}

/// A rise to the last node that is one place of the concentration there: what the outflow subtracts of the inward
/// population for it is an eighth of that population's last place.
TEST(SinglePrecision, LeavesWithoutASmallGradient) {
  const int steps = 40000;
  const double tau = 0.8, w = D2Q5::w(1), rise = 0x1p-24, expected = -w * (tau - 1) * rise;
  SoluteParameters parameters;
  parameters.tau_1 = parameters.tau_h = tau;
  ReactiveBox<D2Q5, float> box(3, 1, [](int, int) { return false; }, parameters, 1.0, {false, true});
  const BoundaryLinks links = find_boundary_links(box.exec, box.nodes, Side::right, 0, 0, D2Q5::Q);
  const ScalarField<double> gain("gain", links.count);
  test::edit(box.acid.C, [&](const auto& C) { C(test::host_copy(links.fluid)(0) - 1) = float(1 - rise); });
  const auto before = test::host_copy(box.acid.h);
  for (int s = 0; s < steps; ++s) {
    Kokkos::deep_copy(box.acid.h, before);
    box.acid.rounding = rounding_of_step<float>(s);
    const std::array condition{outflow_condition(links, parameters, box.acid, gain)};
    dress<D2Q5, float>(box.exec, box.nodes, std::span<const SoluteCondition<float>>(condition));
  }
  EXPECT_NEAR(sum_in_order(gain) / steps, expected, 0.1 * expected);  // 0 by the nearest number
}

/// The same of heat.
TEST(SinglePrecision, LetsHeatLeaveWithoutASmallGradient) {
  const int steps = 40000;
  const double kappa = 0.1, tau = 0.5 + 3 * kappa;
  HeatBox<float> box(
      3, 1, {kappa, kappa, 1, ScalarVelocitySet::d2q5}, [](int, int) { return false; },
      [](int x, int) { return x == 1 ? 1 - 0x1p-23 : 1.0; }, {false, true});
  box.side(Side::right, HeatCondition::outflow, 0);
  const std::vector<double> theta = box.theta();
  for (int s = 0; s < steps; ++s) {
    box.fields.rounding = rounding_of_step<float>(s);
    fill_heat_sides<float>(box.exec, box.fields, box.sides);
  }
  const double expected = -D2Q5::w(1) * (tau - 1) * (theta[2] - theta[1]);
  ASSERT_GT(expected, 1e-9);
  EXPECT_NEAR(box.entered() / steps, expected, 0.05 * expected);  // 0 by the nearest number
}

TEST(SinglePrecision, KeepsTheBalanceOfALongRun) {
  const int n = 100, steps = 100000;
  ReactiveBox<D2Q5, float> box(
      n, 5, [](int, int y) { return y == 0 || y == 4; }, solute_parameters(0.08));
  box.give_concentration(Side::left, [](int) { return 1; });
  box.k = 1e-4;
  for (int s = 0; s < steps; ++s) box.step();
  const double entered = box.gained(), error = entered - box.acid_total() - sum_in_order(box.consumed);
  record("balance_of_a_long_run_in_single_precision", {{"error", std::abs(error) / entered}});
  EXPECT_LT(std::abs(error), 1e-6 * entered);
}

}  // namespace
}  // namespace vug
