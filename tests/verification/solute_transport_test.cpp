// Advection and diffusion of a species away from reactive walls.
#include "../reference/reactive_box.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "support/advance.hpp"
#include "support/host_copy.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace vug {
namespace {

using reference::ReactiveBox;

/// Relative L2 error of a decaying plane wave cos(K.x) carried obliquely by a uniform velocity, after one diffusion
/// time of the wave, on n x n joined nodes at cell Peclet number u n/D = Pe.
template <class Set>
double carried_wave_error(int n, double D, double Pe, const std::function<SoluteParameters(double)>& parameters) {
  const double K = 2 * std::numbers::pi / n;
  const double ux = 0.8 * Pe * D / n, uy = 0.6 * Pe * D / n;
  ReactiveBox<Set, double> box(n, n, [](int, int) { return false; }, parameters(D), 0, {true, true});
  VectorField<double> u("u", box.nodes.capacity);
  Kokkos::deep_copy(Kokkos::subview(u, Kokkos::ALL, 0), ux);
  Kokkos::deep_copy(Kokkos::subview(u, Kokkos::ALL, 1), uy);
  const auto node = test::host_copy(box.nodes.node);
  const auto phase = [&](int i, double t) {
    return K * (box.lattice.x(node(i)) - ux * t) + K * (box.lattice.y(node(i)) - uy * t);
  };
  // start: equilibrium and the first-order non-equilibrium -tau w c.grad C, so that no start-up layer is left
  test::edit(box.acid.h, [&](const auto& h) {
    for (int i = 0; i < box.nodes.count; ++i)
      for (int q = 0; q < Set::Q; ++q) {
        const double cu = Set::c(q, 0) * ux + Set::c(q, 1) * uy;
        const double cK = K * (Set::c(q, 0) + Set::c(q, 1));
        const double C = std::cos(phase(i, 0)), slope = -std::sin(phase(i, 0));
        h(q * box.nodes.capacity + i) = Set::w(q) * (C * (1 + 3 * cu) - (box.parameters.tau_1 - 1) * cK * slope);
      }
  });
  const int steps = static_cast<int>(std::lround(0.5 / (2 * D * K * K)));
  for (int s = 0; s < steps; ++s) advance_solute<Set>(box.exec, box.nodes, box.parameters, u, box.acid);
  const auto C = test::host_copy(box.acid.C);
  const double decay = std::exp(-2 * D * K * K * steps);
  double error = 0, norm = 0;
  for (int i = 0; i < box.nodes.count; ++i) {
    // C is that of the populations as pulled: `steps` streamings after the start
    const double exact = decay * std::cos(phase(i, steps));
    error += (C(i) - exact) * (C(i) - exact);
    norm += exact * exact;
  }
  return std::sqrt(error / norm);
}

TEST(CarriedWave, IsOfSecondOrder) {
  const auto quarter = [](double D) { return solute_parameters(D); };
  const auto paper = [](double D) { return solute_parameters(D, 0.5 + 3 * D + 0.01); };
  for (const double Pe : {0.0, 20.0}) {
    std::array<double, 3> q5, q9;
    for (int k = 0; k < 3; ++k) {
      q5[k] = carried_wave_error<D2Q5>(16 << k, 0.03, Pe, quarter);
      q9[k] = carried_wave_error<D2Q9>(16 << k, 0.03, Pe, paper);
    }
    std::printf("    Pe %g: D2Q5 %.2e %.2e %.2e, D2Q9 %.2e %.2e %.2e\n", Pe, q5[0], q5[1], q5[2], q9[0], q9[1], q9[2]);
    for (int k = 0; k < 3; ++k)
      test::record("solute_carried_wave", {{"Pe", Pe}, {"n", 16 << k}, {"D2Q5", q5[k]}, {"D2Q9", q9[k]}});
    for (const auto& e : {q5, q9}) {
      EXPECT_GE(std::log2(e[0] / e[1]), 1.9);
      EXPECT_GE(std::log2(e[1] / e[2]), 1.95);
    }
    EXPECT_LT(q5[2], 1e-2);
    EXPECT_LT(q9[2], 1e-2);
  }
}

TEST(AdvectiveForm, UniformConcentrationStaysUniformInADivergentField) {
  // a steady velocity with sources and sinks around solid blocks: conservation form piles solute up, advective form not
  const auto solid = [](int x, int y) { return (x / 3 + y / 2) % 3 == 0; };
  const auto largest_deviation = [&](bool corrected) {
    ReactiveBox<D2Q5, double> box(30, 20, solid, solute_parameters(0.02), 1.0, {true, true});
    VectorField<double> u("u", box.nodes.capacity);
    test::edit(u, [&](const auto& host) {
      for (int i = 0; i < box.nodes.count; ++i) {
        host(i, 0) = 0.02 * std::sin(1.3 * i);
        host(i, 1) = 0.02 * std::cos(0.7 * i);
      }
    });
    ScalarField<double> e("e", box.nodes.capacity), ledger("ledger", block_count(box.nodes.count));
    advective_defect<D2Q5>(box.exec, box.nodes, u, e);
    const double before = box.acid_total();
    for (int s = 0; s < 2000; ++s)
      if (corrected)
        advance_solute<D2Q5>(box.exec, box.nodes, box.parameters, u, e, box.acid, ledger);
      else
        advance_solute<D2Q5>(box.exec, box.nodes, box.parameters, u, box.acid);
    EXPECT_NEAR(box.acid_total() - before, sum_in_order(ledger), 1e-10);
    const FieldRange range = field_range(box.exec, box.acid.C, box.nodes.count);
    return std::max(range.max - 1, 1 - range.min);
  };
  const double plain = largest_deviation(false), corrected = largest_deviation(true);
  std::printf("    deviation from uniform: %.2e, in advective form %.2e\n", plain, corrected);
  EXPECT_GT(plain, 0.1);
  EXPECT_LT(corrected, 0.02);
}

TEST(AdvectiveForm, BooksWhatItTakesInSinglePrecision) {
  // 2e-9 of C is a fifteenth of the last place of a population of C/3
  const int n = 30, steps = 1000;
  for (const float little : {2e-9F, 2e-5F}) {
    ReactiveBox<D2Q5, float> box(n, n, [](int, int) { return false; }, solute_parameters(0.02), 1.0, {true, true});
    const VectorField<float> u("u", box.nodes.capacity);
    const ScalarField<float> e("e", box.nodes.capacity);
    const ScalarField<double> booked("booked", block_count(box.nodes.count));
    Kokkos::deep_copy(e, little);
    const double before = box.acid_total(), taken = before * (1 - std::pow(1 + double(little), -steps));
    for (int step = 0; step < steps; ++step) {
      box.acid.rounding = rounding_of_step<float>(step);
      advance_solute<D2Q5>(box.exec, box.nodes, box.parameters, u, e, box.acid, booked);
    }
    EXPECT_NEAR(before - box.acid_total(), taken, 0.02 * taken) << little;
    EXPECT_NEAR(-sum_in_order(booked), taken, 1e-4 * taken) << little;
  }
}

}  // namespace
}  // namespace vug
