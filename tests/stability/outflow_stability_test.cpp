// Sides that heat and solutes leave without gradient, at the extremes: nothing grows, whatever the diffusivity.
#include "../reference/reactive_box.hpp"
#include "support/heat_box.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug {
namespace {

using reference::ReactiveBox;
using test::HeatBox;

constexpr int n = 30, steps = 3000;

/// Blocks of three, a third of them rock.
bool rock(int x, int y) {
  return (x / 3 * 5 + y / 3 * 7) % 3 == 0;
}

double noise(int x, int y) {
  return (x * 7 + y * 13) % 5 < 2 ? 1.0 : -1.0;
}

/// What grew by a thousandth in a step would be twenty times as large after these.
constexpr double bound = 4;

/// Noise between three outflows and a side at 0. With a slope of tau - 1 at any tau D = 2 is lost.
TEST(OutflowStability, OfHeatHoldsForAnyDiffusivityAndContrast) {
  for (const ScalarVelocitySet set : test::velocity_sets)
    for (const double diffusivity : {1e-4, 0.05, 0.5, 0.99, 1.01, 2.0, 10.0, 1e3})
      for (const double contrast : {1e-2, 1.0, 1e2}) {
        HeatBox<double> box(n, n, {diffusivity, diffusivity * contrast, 1.6, set}, rock, noise);
        box.side(Side::left, HeatCondition::temperature, 0);
        for (const Side side : {Side::right, Side::bottom, Side::top}) box.side(side, HeatCondition::outflow, 0);
        box.run(steps);
        const HeatExtremes found = heat_extremes(box.exec, box.fields);
        EXPECT_EQ(found.not_finite, 0);
        EXPECT_LT(std::max(-found.lowest, found.highest), bound)
            << "D " << diffusivity << ", contrast " << contrast << ", " << test::name_of(set);
      }
}

template <class Set>
void expect_bounded_solute(const SoluteParameters& parameters) {
  ReactiveBox<Set, double> box(n, n, rock, parameters, 1);
  box.give_concentration(Side::left, [](int y) { return y % 2 == 0 ? 0.0 : 2.0; });
  std::vector<BoundaryLinks> sides;
  for (const Side side : {Side::right, Side::bottom, Side::top})
    sides.push_back(find_boundary_links(box.exec, box.nodes, side, 0, n - 1, Set::Q));
  const ScalarField<double> gain("gain", 3 * n);
  for (int s = 0; s < steps; ++s) {
    for (const BoundaryLinks& out : sides) dress_outflow<Set>(box.exec, box.nodes, out, box.parameters, box.acid, gain);
    box.step();
  }
  const auto C = test::host_copy(box.acid.C);
  for (int i = 0; i < box.nodes.count; ++i)
    ASSERT_LT(std::abs(C(i)), bound) << "tau " << parameters.tau_1 << ", " << Set::Q;
}

/// On D2Q9 to 10: at 1000 it grows, with and without the slope.
TEST(OutflowStability, OfSolutesHoldsForAnyDiffusivity) {
  for (const double diffusivity : {1e-4, 0.05, 0.5, 0.99, 1.01, 2.0, 10.0, 1e3}) {
    expect_bounded_solute<D2Q5>(solute_parameters(diffusivity));
    if (diffusivity <= 10) expect_bounded_solute<D2Q9>(solute_parameters(diffusivity));
  }
}

}  // namespace
}  // namespace vug
