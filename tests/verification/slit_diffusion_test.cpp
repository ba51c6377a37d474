// Diffusion along cracks narrower than a cell: what a slit of w cells passes is w D times the gradient along its line.
#include "kernels/solute/slit_diffusion.hpp"

#include "../reference/reactive_box.hpp"
#include "support/crack.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace vug {
namespace {

using reference::ReactiveBox;
using test::Crack;
using test::Direction;

/// A species in a crack of which every node has the same openness.
template <class Set, class T = double>
struct Slit {
  ReactiveBox<Set, T> box;
  SlitNodes slits;
  VectorField<T> u;

  Slit(int nx, int ny, const std::function<bool(int, int)>& solid, double D, double openness,
       std::array<bool, 2> periodic = {false, false}, double C0 = 0)
      : box(nx, ny, solid, solute_parameters(D), C0, periodic),
        slits(Crack::all_nodes(box.nodes, 0)),
        u("u", box.nodes.capacity) {
    slits.openness = ScalarField<double>("openness", box.nodes.count);
    Kokkos::deep_copy(slits.openness, openness);
  }
  void step() {
    box.step();
    resist_in_slits<Set>(box.exec, box.nodes, slits, SoluteCarrier<T>{}, box.parameters, box.acid);
  }
  void step_with_flow() {
    for (const auto& side : box.given)
      dress_concentration<Set>(box.exec, box.nodes, side.links, side.C_b, box.acid, side.gain);
    const Displacement<T> way(u);
    advance_solute<Set>(box.exec, box.nodes, box.parameters, way, box.acid);
    resist_in_slits<Set>(box.exec, box.nodes, slits, SoluteCarrier<T>{way, {}}, box.parameters, box.acid);
  }
};

/// A row of n nodes between walls, C = 1 held at its left end and `right` at the other.
template <class Set>
Slit<Set> row(int n, double D, double w, double right = 0) {
  Slit<Set> slit(
      n, 3, [](int, int y) { return y != 1; }, D, slit_openness(w, 0));
  slit.box.give_concentration(Side::left, [](int) { return 1.0; });
  slit.box.give_concentration(Side::right, [=](int) { return right; });
  return slit;
}

/// n - 1 links of 1/(w D) and a half of 1/D at each end.
TEST(SlitDiffusion, OfARowIsThatOfItsWidth) {
  constexpr int n = 12;
  for (const double D : {0.02, 0.15, 0.8})
    for (const double w : {0.01, 0.1, 0.5, 1.0}) {
      if (w * D < 1e-3) continue;  // millions of steps
      Slit<D2Q5> slit = row<D2Q5>(n, D, w);
      const int long_enough = static_cast<int>(3 * n * n / (w * D)) + 1000;
      for (int step = 0; step < long_enough; ++step) slit.step();
      const double before = slit.box.gained(), stored = slit.box.acid_total();
      const double entered = sum_in_order(slit.box.given[0].gain);
      for (int step = 0; step < 1000; ++step) slit.step();
      const double flux = (sum_in_order(slit.box.given[0].gain) - entered) / 1000;
      EXPECT_NEAR(flux * ((n - 1) / (w * D) + 1 / D), 1, 1e-6) << "D " << D << ", w " << w;
      EXPECT_NEAR(slit.box.acid_total() - stored, slit.box.gained() - before, 1e-12);
    }
}

/// A wave along a crack that closes on itself decays at the rate D k^2 of the slit, where its nodes hold (1 + s)/sqrt(1
/// + s^2)/w times as much as it does.
TEST(SlitDiffusion, IsTheSameInEveryDirection) {
  constexpr double D = 1.0 / 6, w = 0.3;
  for (const Direction& direction : test::directions) {
    const Crack crack(direction);
    const auto open = crack.open(1);
    const double slope = direction.slope(), length = crack.length(), k = 2 * std::numbers::pi / length;
    Slit<D2Q5> slit(crack.columns, crack.rows,
                    [&](int x, int y) { return !open[static_cast<std::size_t>(y) * crack.columns + x]; }, D,
                    slit_openness(w, slope), {true, true});
    const auto node = test::host_copy(slit.box.nodes.node);
    const auto wave = [&](int i) {
      const double x = slit.box.lattice.x(node(i)) + 0.5, y = slit.box.lattice.y(node(i)) + 0.5;
      return std::cos(k * (x * crack.over[0] + y * crack.over[1]) / length);
    };
    test::edit(slit.box.acid.h, [&](const auto& h) {
      for (int i = 0; i < slit.box.nodes.count; ++i)
        for (int q = 0; q < D2Q5::Q; ++q) h(q * slit.box.nodes.capacity + i) = D2Q5::w(q) * wave(i);
    });
    const auto amplitude = [&] {
      const auto C = test::host_copy(slit.box.acid.C);
      double sum = 0;
      for (int i = 0; i < slit.box.nodes.count; ++i) sum += C(i) * wave(i);
      return sum;
    };
    const double rate = w * D * k * k * std::sqrt(1 + slope * slope) / (1 + slope);
    const int span = static_cast<int>(1 / rate);
    for (int step = 0; step < span; ++step) slit.step();
    const double first = amplitude();
    for (int step = 0; step < span; ++step) slit.step();
    const double error = std::log(first / amplitude()) / (rate * span) - 1;
    EXPECT_LT(std::abs(error), 4e-3) << direction.degrees << " degrees";
    test::record("slit_diffusion", {{"degrees", direction.degrees}, {"error", error}});
  }
}

/// What walls on both sides take up, k' = 1/(1/k + 1/(2 D)) from half a cell away, and what comes along the slit: a
/// profile that falls by lambda from node to node, lambda + 1/lambda - 2 = 2 k'/(w D).
TEST(SlitDiffusion, ReachesAsFarAsTheReactionLetsIt) {
  constexpr int n = 80;
  constexpr double D = 0.1, w = 0.1, k = 1e-4;
  Slit<D2Q5> slit = row<D2Q5>(n, D, w);
  slit.box.k = k;
  for (int step = 0; step < 100000; ++step) slit.step();
  const auto C = slit.box.concentration(slit.box.acid);
  const double half = 1 / (1 / k + 1 / (2 * D)) / (w * D);
  const double lambda = 1 + half - std::sqrt(half * (half + 2));
  for (int x = 5; x < 30; x += 5) EXPECT_NEAR(C[n + x + 1] / C[n + x], lambda, 1e-4) << x;
}

/// Steady flow u along a slit of length L at whose end C = 0: C = (1 - exp(-Pe x))/(1 - exp(-Pe L)), x from the end and
/// Pe = u/(w D). The half cells at the ends, which have the whole of D, are as long as w/2.
TEST(SlitDiffusion, LetsTheFlowCarryWhatItCarries) {
  constexpr int n = 20;
  constexpr double D = 0.1, w = 0.1, u = 2e-3;
  Slit<D2Q5> even = row<D2Q5>(n, D, w, 1), falling = row<D2Q5>(n, D, w);
  for (Slit<D2Q5>* slit : {&even, &falling}) Kokkos::deep_copy(Kokkos::subview(slit->u, Kokkos::ALL, 0), u);
  test::edit(even.box.acid.h, [&](const auto& h) {
    for (int i = 0; i < n; ++i)
      for (int q = 0; q < D2Q5::Q; ++q) h(q * even.box.nodes.capacity + i) = D2Q5::w(q) * (1 + 3 * D2Q5::c(q, 0) * u);
  });
  for (int step = 0; step < 40000; ++step) {
    even.step_with_flow();
    falling.step_with_flow();
  }
  const auto uniform = even.box.concentration(even.box.acid), C = falling.box.concentration(falling.box.acid);
  for (int x = 0; x < n; ++x) EXPECT_NEAR(uniform[n + x], 1, 1e-12) << x;
  const double Pe = u / (w * D), length = n - 1 + w;
  for (int x = 0; x < n; ++x) {
    const double from_end = n - 1 - x + 0.5 * w;
    EXPECT_NEAR(C[n + x], std::expm1(-Pe * from_end) / std::expm1(-Pe * length), 2e-3) << x;
  }
}

/// Where a step of the flow outruns diffusion by far, nothing rises above what comes in.
TEST(SlitDiffusion, MakesNoWavesWhereFlowDecides) {
  constexpr int n = 40;
  Slit<D2Q5> slit = row<D2Q5>(n, 0.02, 0.01);
  Kokkos::deep_copy(Kokkos::subview(slit.u, Kokkos::ALL, 0), 0.02);  // 100 times as far
  for (int step = 0; step < 4000; ++step) {
    slit.step_with_flow();
    if (step % 100 > 0) continue;
    for (const double C : slit.box.concentration(slit.box.acid)) EXPECT_LT(std::abs(C - 0.5), 0.51) << step;
  }
}

}  // namespace
}  // namespace vug
