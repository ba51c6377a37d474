// Where the solute scheme holds, and where it breaks as docs/stability.md says.
#include "../reference/reactive_box.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/scalar/advective_form.hpp"
#include "support/advance.hpp"
#include "support/dress_one.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace vug {
namespace {

using reference::ReactiveBox;

/// Noise between 0 and 1 carried over joined sides at `speed` along 0, 22.5 and 45 degrees for `steps` steps.
template <class Set>
bool stays_bounded(SoluteParameters p, double speed, int steps) {
  for (const double degrees : {0.0, 22.5, 45.0}) {
    ReactiveBox<Set, double> box(24, 24, [](int, int) { return false; }, p, 0, {true, true});
    set_random(box);
    VectorField<double> u("u", box.nodes.capacity);
    Kokkos::deep_copy(Kokkos::subview(u, Kokkos::ALL, 0), speed * std::cos(degrees * std::numbers::pi / 180));
    Kokkos::deep_copy(Kokkos::subview(u, Kokkos::ALL, 1), speed * std::sin(degrees * std::numbers::pi / 180));
    for (int n = 0; n < steps; ++n) advance_solute<Set>(box.exec, box.nodes, p, u, box.acid);
    const FieldRange range = field_range(box.exec, box.acid.C, box.nodes.count);
    if (range.first_outside >= 0 || range.max > 5 || range.min < -5) return false;
  }
  return true;
}

TEST(SoluteStability, TheDefaultHoldsAtEveryDiffusivityAndSpeed) {
  for (const double D : {1.5, 0.3, 0.03, 1e-3, 1e-5, 1.0 / 30000})  // tau_1 from 0.50003 to 5
    for (const double speed : {0.05, 0.4})
      EXPECT_TRUE(stays_bounded<D2Q5>(solute_parameters(D), speed, 1500)) << D << ' ' << speed;
}

TEST(SoluteStability, ThePapersSchemeHoldsWithItsOwnParametersAndBreaksAsDocumented) {
  EXPECT_TRUE(stays_bounded<D2Q9>(solute_parameters(0.02, 0.7), 0.3, 1500));    // Table 2
  EXPECT_TRUE(stays_bounded<D2Q9>(solute_parameters(0.03, 0.6), 0.3, 1500));    // its validation
  EXPECT_FALSE(stays_bounded<D2Q9>(solute_parameters(0.001, 0.7), 0.3, 4000));  // small D at the same tau_h
  EXPECT_TRUE(stays_bounded<D2Q9>(solute_parameters(0.03, 0.51), 0.0, 4000));   // tau_B < 0 is no harm in itself,
  EXPECT_FALSE(stays_bounded<D2Q9>(SoluteParameters{0.59, 0.49}, 0.0, 4000));   // tau_h below 1/2 is
}

/// A channel of n nodes between reactive walls with a parabolic flow of mean speed u.
FieldRange channel(int n, double u_mean, double D, double k) {
  ReactiveBox<D2Q5, double> box(
      120, n + 2, [=](int, int y) { return y == 0 || y == n + 1; }, solute_parameters(D), 0);
  box.k = k;
  box.give_concentration(Side::left, [](int) { return 1.0; });
  const BoundaryLinks out = find_boundary_links(box.exec, box.nodes, Side::right, 0, n + 1, 5);
  mark_open(box.exec, box.nodes, out);
  mark_open(box.exec, box.nodes, box.given[0].links);
  const ScalarField<double> gain("gain", out.count);
  VectorField<double> u("u", box.nodes.capacity);
  test::edit(u, [&, node = test::host_copy(box.nodes.node)](const auto& host) {
    for (int i = 0; i < box.nodes.count; ++i) {
      const double s = (box.lattice.y(node(i)) - 0.5) / n;
      host(i, 0) = 6 * u_mean * s * (1 - s);
    }
  });
  ScalarField<double> e("e", box.nodes.capacity), ledger("ledger", block_count(box.nodes.count));
  advective_defect<D2Q5>(box.exec, box.nodes, u, e);
  for (int step = 0; step < 6000; ++step) {
    dress_outflow<D2Q5>(box.exec, box.nodes, out, box.parameters, box.acid, gain);
    dress_concentration<D2Q5>(box.exec, box.nodes, box.given[0].links, 1.0, box.acid, box.given[0].gain);
    box.react();
    advance_solute<D2Q5>(box.exec, box.nodes, box.parameters, u, e, box.acid, ledger);
  }
  return field_range(box.exec, box.acid.C, box.nodes.count);
}

TEST(SoluteStability, ChannelsOfOneToSeventeenNodesAtAGridPecletNumberOfAThousand) {
  for (const int n : {1, 3, 5, 17})
    for (const double k : {1e-6, 1e6}) {
      const FieldRange range = channel(n, 0.05, 5e-5, k);  // u dx/D = 1000
      std::printf("    %2d nodes, k %g: C from %.3f to %.3f\n", n, k, range.min, range.max);
      EXPECT_EQ(range.first_outside, -1);
      EXPECT_LT(range.max, 2);
      EXPECT_GT(range.min, -1);
    }
}

}  // namespace
}  // namespace vug
