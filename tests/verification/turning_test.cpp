// Steps of a scalar that come to take more lattice steps, or fewer: what is steady stays, what is carried and decays
// goes on as if nothing had happened.
#include "kernels/scalar/turning.hpp"

#include "../reference/reactive_box.hpp"
#include "support/advance.hpp"
#include "support/heat_box.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <vector>

namespace vug {
namespace {

using reference::ReactiveBox;
using test::HeatBox;

TEST(Turning, IsTheOrdinaryCollisionAtAStretchOfOne) {
  for (const double tau : {0.51, 0.8, 1.0, 3.0}) {
    EXPECT_EQ(turning(tau, 1).rate, 1 / tau);
    EXPECT_EQ(turning(tau, 1).carried, 1);
    EXPECT_NEAR(turning(tau, 1 + 1e-13).rate, 1 / tau, 1e-12);
  }
  // 1 - rate would be 1: finite, and the displacement of a uniform flow is right all the same
  const Turning none = turning(1.5, 2);
  EXPECT_TRUE(std::isfinite(none.carried));
  EXPECT_NEAR((1 - none.rate) / 2 + none.rate * none.carried, 1, 1e-12);
}

HeatParameters stretched(HeatParameters p, double stretch) {
  p.fluid_diffusivity *= stretch;
  p.solid_diffusivity *= stretch;
  return p;
}

/// A slab of fluid on one of solid, hot on one side and cold on the other: the steady profile is that of any time step.
TEST(Turning, LeavesASteadyConductionAlone) {
  const int n = 5;
  const HeatParameters p{0.05, 0.12, 0.625};
  const double conductivity = 0.625 * 0.12 / 0.05, contact = 1 / (1 + conductivity);
  const auto exact = [&](int x) {
    const double at = x + 0.5;
    return at < n ? 1 - (1 - contact) * at / n : contact * (2 * n - at) / n;
  };
  for (const bool turns : {true, false}) {
    double off = 0;
    for (const double stretch : {2.0, 4.0, 0.5}) {
      HeatBox<double> box(
          2 * n, 2, p, [&](int x, int) { return x >= n; }, [&](int x, int) { return exact(x); }, {false, true});
      box.side(Side::left, HeatCondition::temperature, 1);
      box.side(Side::right, HeatCondition::temperature, 0);
      box.run(10000);
      set_heat_rates(turns ? p : stretched(p, stretch), turns ? stretch : 1, box.fields);
      box.run(1);
      set_heat_rates(stretched(p, stretch), 1, box.fields);
      for (int step = 0; step < 5; ++step) {
        box.run(1);
        for (int x = 0; x < 2 * n; ++x) off = std::max(off, std::abs(box.theta()[x] - exact(x)));
      }
    }
    if (turns)
      EXPECT_LT(off, 1e-12);
    else
      EXPECT_GT(off, 1e-3) << "new rates alone would do";
  }
}

/// Lattice steps that one step takes, one after the other: 64 of one, then of two, four, eight, four, two.
std::vector<int> intervals() {
  std::vector<int> list;
  for (const int interval : {1, 2, 4, 8, 4, 2}) list.insert(list.end(), 64 / interval, interval);
  return list;
}

constexpr int side = 64;
constexpr double wave = 2 * std::numbers::pi / side, speed = 0.02, diffusivity = 0.02;

/// cos(K (x + y)) carried by (speed, speed), after some time.
double exact_wave(int x, int y, double t, double from) {
  return std::exp(-2 * diffusivity * wave * wave * (t - from)) * std::cos(wave * (x + y - 2 * speed * t));
}

/// Largest deviation from the exact wave while the intervals change.
double carried_heat(const std::vector<int>& intervals) {
  const HeatParameters one{diffusivity, diffusivity, 1};
  HeatBox<double> box(
      side, side, stretched(one, intervals[0]), [](int, int) { return false; },
      [](int x, int y) { return exact_wave(x, y, 0, 0); }, {true, true});
  box.flow([](int, int) { return std::array{speed, speed}; });
  double off = 0, time = 0;
  for (std::size_t s = 0; s < intervals.size(); ++s) {
    const int now = intervals[s], next = s + 1 < intervals.size() ? intervals[s + 1] : now;
    const double stretch = static_cast<double>(next) / now;
    for (int axis = 0; axis < 2; ++axis) join_heat_sides(box.exec, box.fields, axis);
    set_heat_rates(stretched(one, now), stretch, box.fields);
    Displacement<double> u(box.u, next);
    u.steps *= turning(0.5 + 3 * now * diffusivity, stretch).carried;
    conduct_and_advect(box.exec, box.nodes, box.rows, u, box.defect, box.lagged, box.fields, box.created);
    if (stretch != 1) stretch_lagged(box.exec, box.nodes.count, stretch, box.lagged);
    time += now;
    const std::vector<double> theta = box.theta();
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) off = std::max(off, std::abs(theta[y * side + x] - exact_wave(x, y, time, 0)));
  }
  return off;
}

double carried_solute(const std::vector<int>& intervals) {
  const auto of = [](int interval) { return solute_parameters(interval * diffusivity); };
  ReactiveBox<D2Q5, double> box(side, side, [](int, int) { return false; }, of(intervals[0]), 0, {true, true});
  VectorField<double> u("u", box.nodes.capacity);
  Kokkos::deep_copy(u, speed);
  const auto node = test::host_copy(box.nodes.node);
  test::edit(box.acid.h, [&](const auto& h) {
    for (int i = 0; i < box.nodes.count; ++i)
      for (int q = 0; q < D2Q5::Q; ++q)
        h(q * box.nodes.capacity + i) = D2Q5::w(q) * exact_wave(box.lattice.x(node(i)), box.lattice.y(node(i)), 0, 0);
  });
  double off = 0, time = 0;
  for (std::size_t s = 0; s < intervals.size(); ++s) {
    const int now = intervals[s], next = s + 1 < intervals.size() ? intervals[s + 1] : now;
    const SoluteParameters p = next == now ? of(now) : turning_parameters(of(now), static_cast<double>(next) / now);
    advance_solute<D2Q5>(box.exec, box.nodes, p, Displacement<double>(u, next), box.acid);
    time += now;
    const auto C = test::host_copy(box.acid.C);
    for (int i = 0; i < box.nodes.count; ++i)
      off = std::max(off, std::abs(C(i) - exact_wave(box.lattice.x(node(i)), box.lattice.y(node(i)), time, 0)));
  }
  return off;
}

/// As near to the exact wave as where every step is taken.
TEST(Turning, CarriesAWaveOnThroughEveryChange) {
  const std::vector<int> ones(6 * 64, 1);
  for (const auto& [name, carried] :
       {std::pair{"heat", std::function(carried_heat)}, std::pair{"solute", std::function(carried_solute)}}) {
    const double every_step = carried(ones), changing = carried(intervals());
    std::printf("    %s: off by %.2e with changes, %.2e without\n", name, changing, every_step);
    EXPECT_LT(changing, 1.1 * every_step) << name;
  }
}

}  // namespace
}  // namespace vug
