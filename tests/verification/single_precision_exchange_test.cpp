// Small exchanges in single precision, below the last place of what they change in a step: with the surroundings,
// between fluid and rock, and by the advective form. Against analytic solutions and balances.
#include "../reference/reactive_box.hpp"
#include "support/heat_box.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug {
namespace {

using reference::ReactiveBox;
using test::HeatBox;
using test::record;

/// Heat lost from rock so conductive that it is of one temperature: Newton's law of cooling,
/// c n dtheta/dt = -h (theta - theta_out).
TEST(SinglePrecision, CoolsThroughASmallTransferCoefficient) {
  const int n = 5, steps = 400000;
  const double capacity = 0.625, warm = 100;
  for (const ScalarVelocitySet set : test::velocity_sets)
    for (const double h : {1e-8, 3e-9}) {
      HeatBox<float> box(
          n, 1, {0.1, 0.1, capacity, set}, [](int, int) { return true; }, [&](int, int) { return warm; },
          {false, true});
      HeatSide side = test::whole_side(box.lattice, Side::left, HeatCondition::convection, 0);
      side.transfer = h;
      box.side(side);
      const double before = box.energy();
      box.run(steps);
      const double lost = capacity * n * warm * -std::expm1(-h * steps / (capacity * n));
      record("small_transfer_lost", {{"set", test::name_of(set)}, {"h", h}, {"share", (before - box.energy()) / lost}});
      EXPECT_NEAR(before - box.energy(), lost, 0.03 * lost) << test::name_of(set) << ", " << h;
      EXPECT_NEAR(-box.entered(), lost, 0.02 * lost) << test::name_of(set) << ", " << h;
    }
}

/// Fluid and rock side by side in a closed box: heat passes between them, and none is made.
TEST(SinglePrecision, KeepsTheHeatThatPassesBetweenFluidAndRock) {
  const int n = 20, steps = 300000;
  const double sigma = 3;
  for (const ScalarVelocitySet set : test::velocity_sets) {
    HeatBox<float> box(
        n, 1, {0.001, 0.002, sigma, set}, [](int x, int) { return x >= n / 2; },
        [](int x, int) { return x < n / 2 ? 101 : 100; }, {false, true});
    const double before = box.energy();
    box.run(steps);
    const double made = box.energy() - before;
    record("interface_balance", {{"set", test::name_of(set)}, {"made", std::abs(made) / (n / 2)}});
    EXPECT_LT(std::abs(made), 2e-3 * (n / 2)) << test::name_of(set);  // of the heat by which the fluid is warmer
  }
}

/// A uniform defect e of the velocities takes C e in every step. It is small beside what a gradient makes populations
/// exchange.
TEST(SinglePrecision, AddsASmallPartBesideLargeFluxes) {
  const int n = 5, steps = 1000000;
  for (const double e : {1e-9, -3e-9}) {
    ReactiveBox<D2Q5, float> box(n, 1, [](int, int) { return false; }, solute_parameters(0.1), 1.0, {false, true});
    box.give_concentration(Side::left, [](int) { return 1; });
    box.give_concentration(Side::right, [](int) { return 11; });
    for (int s = 0; s < 2000; ++s) box.step();
    const VectorField<float> still("u", box.nodes.capacity);
    const ScalarField<float> defect("e", box.nodes.capacity);
    Kokkos::deep_copy(defect, static_cast<float>(e));
    const ScalarField<double> correction("correction", block_count(box.nodes.count));
    const double before = box.acid_total() - box.gained();
    for (int s = 0; s < steps; ++s) {
      box.acid.rounding = rounding_of_step<float>(++box.steps);
      for (const auto& g : box.given) dress_concentration<D2Q5>(box.exec, box.nodes, g.links, g.C_b, box.acid, g.gain);
      advance_solute<D2Q5>(box.exec, box.nodes, box.parameters, still, defect, box.acid, correction);
    }
    const double made = -6 * n * e * steps;
    EXPECT_NEAR(sum_in_order(correction), made, 1e-3 * std::abs(made));
    EXPECT_NEAR(box.acid_total() - box.gained() - before, made, 0.01 * std::abs(made));
  }
}

TEST(SinglePrecision, AddsASmallPartBesideLargeFluxesOfHeat) {
  const int n = 5, steps = 300000;
  for (const ScalarVelocitySet set : test::velocity_sets)
    for (const double e : {1e-9, -3e-9}) {
      HeatBox<float> box(
          n, 1, {0.1, 0.1, 0.625, set}, [](int, int) { return false; }, [](int, int) { return 160; }, {false, true});
      box.side(Side::left, HeatCondition::temperature, 110);
      box.side(Side::right, HeatCondition::temperature, 210);
      box.flow([](int, int) { return std::array{0.0, 0.02}; });  // along the walls, which changes nothing
      box.run(2000);
      Kokkos::deep_copy(box.created, 0.0);
      const double before = box.energy() - box.entered();
      for (int s = 0; s < steps; ++s) {
        Kokkos::deep_copy(box.defect, static_cast<float>(e));
        box.run(1);
      }
      const double made = -160 * n * e * steps;
      EXPECT_NEAR(sum_in_order(box.created), made, 1e-3 * std::abs(made)) << test::name_of(set) << ", " << e;
      EXPECT_NEAR(box.energy() - box.entered() - before, made, 0.03 * std::abs(made))
          << test::name_of(set) << ", " << e;
    }
}

/// Acid that the walls of a channel, `height` cells wide, take by the paper's law at the Damkohler number Da of a node.
template <class T>
double taken_by_papers_wall(int height, double D, double Da, int steps) {
  const int n = 2;
  ReactiveBox<D2Q5, T> box(n, height + 2, [height](int, int y) { return y == 0 || y == height + 1; },
                           solute_parameters(D), 1.0, {true, true});
  box.k = Da * D;
  box.wall.law = ReactiveWallLaw::paper;
  box.wall.D_reactant = box.wall.D_product = D;
  for (int s = 0; s < steps; ++s) box.step();
  return n * height - box.acid_total();
}

/// The numbers of docs/model.md, "The paper's wall".
TEST(SinglePrecision, LosesASlowReactionAtThePapersWall) {
  const int height = 11;
  const auto share = [&](double D, double Da) {
    const int steps = static_cast<int>(std::min(100000.0, 0.05 * height / (Da * D)));
    return taken_by_papers_wall<float>(height, D, Da, steps) / taken_by_papers_wall<double>(height, D, Da, steps);
  };
  for (const double D : {0.01, 0.1, 0.5}) {
    EXPECT_NEAR(share(D, 1e-4), 1, 1e-3) << D;
    EXPECT_NEAR(share(D, 3e-5), 1, 5e-3) << D;
  }
  EXPECT_NEAR(share(0.01, 1e-6), 1.45, 0.1);
  EXPECT_NEAR(share(0.01, 1e-7), 0, 0.01);
}

}  // namespace
}  // namespace vug
