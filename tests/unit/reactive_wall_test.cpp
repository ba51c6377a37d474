// What acid meets at sides and at rock, on lattices small enough to follow by hand.
#include "../reference/drawn_box.hpp"
#include "kernels/reaction/reactive_wall_kernel.hpp"
#include "support/dress_one.hpp"

#include <gtest/gtest.h>

namespace vug {
namespace {

using reference::Box;
using reference::box_of;
using reference::concentration;
using reference::uniform_rate;
using test::edit;
using test::host_copy;

TEST(SoluteBoundary, GivenConcentrationIsHeldHalfWay) {
  // one fluid node between C = 1 on the left and C = 0 on the right: 1/2 in the middle at rest
  Box box(
      1, 1, [](int, int) { return false; }, solute_parameters(0.2), 0.9);
  box.give_concentration(Side::left, [](int) { return 1.0; });
  box.give_concentration(Side::right, [](int) { return 0.0; });
  const double before = box.acid_total();
  for (int n = 0; n < 200; ++n) box.step();
  EXPECT_NEAR(concentration(box, 0, 0), 0.5, 1e-14);
  EXPECT_NEAR(box.acid_total(), before + box.gained(), 1e-14);
}

TEST(SoluteBoundary, OutflowReturnsThePopulationThatGoesTheOtherWayLessWhatItDiffuses) {
  const SoluteParameters parameters = solute_parameters(0.2);
  Box box(
      2, 1, [](int, int) { return false; }, parameters, 0);
  edit(box.acid.C, [](const auto& C) { C(0) = 3, C(1) = 1; });
  edit(box.acid.h, [&](const auto& h) {
    for (int slot = 0; slot < 5 * box.nodes.capacity; ++slot) h(slot) = slot;
  });
  const BoundaryLinks links = find_boundary_links(box.exec, box.nodes, Side::right, 0, 0, 5);
  const ScalarField<double> gain("gain", links.count);
  dress_outflow<D2Q5>(box.exec, box.nodes, links, parameters, box.acid, gain);
  const double diffused = (parameters.tau_1 - 1) / 6 * (1 - 3);
  EXPECT_NEAR(host_copy(box.acid.h)(1 * box.nodes.capacity + 1), 3 * box.nodes.capacity + 1 - diffused, 1e-12);
  EXPECT_NEAR(host_copy(gain)(0), 2 * box.nodes.capacity - diffused, 1e-12);
}

TEST(ReactiveWall, ProductAppearsAsAcidDisappears) {
  Box box = box_of({"...", ".#.", "..."}, 0.8);
  box.add_product(0.1);
  box.wall.inverse_equilibrium = 0.5;
  box.wall.molar_volume = 0;
  box.k = 0.3;
  const double sum = box.acid_total() + box.product_total(), acid = box.acid_total();
  for (int n = 0; n < 3000; ++n) box.step();
  EXPECT_NEAR(box.acid_total() + box.product_total(), sum, 1e-13);
  EXPECT_NEAR(acid - box.acid_total(), sum_in_order(box.consumed), 1e-13);
  // equilibrium: C1 = C2/K_eq everywhere
  EXPECT_NEAR(concentration(box, 0, 0), 0.3, 1e-12);
  EXPECT_EQ(box.solid_total(), 1);  // reacts without dissolving
}

struct WarmToTheRight {
  Lattice lattice;
  KOKKOS_FUNCTION void announce(int, int) const {}
  KOKKOS_FUNCTION double operator()(int solid, int fluid) const {
    return 300 + 5.0 * (lattice.x(solid) + lattice.x(fluid));
  }
};

TEST(ReactiveWall, EveryFaceOfAPixelReactsAtItsOwnTemperature) {
  Box box = box_of({"....", ".##.", "...."}, 0.8);
  box.wall.molar_volume = 1;
  const ArrheniusRate<WarmToTheRight> rate{1e-3, 7553.1, 300, {box.lattice}};
  find_reactive_links<D2Q5>(box.exec, box.nodes, box.surface, box.wall.law, box.links);
  set_conductances<D2Q5>(box.exec, box.nodes, box.surface, box.wall, rate, box.normal, box.links);
  react_at_wall<D2Q5>(box.exec, box.nodes, box.wall, box.links, box.acid,
                      static_cast<const SoluteFields<double>*>(nullptr));
  const int left = box.lattice.node(1, 1), right = box.lattice.node(2, 1);
  EXPECT_EQ(host_copy(box.dissolved)(left), 0) << "not yet booked";
  const ReactionLedger ledger{box.V, box.dissolved, box.consumed, {}, {}};
  book_turnover(box.exec, box.surface, box.wall, box.links, ledger);
  const auto at = [](double T) { return kinetic_conductance(arrhenius(1e-3, 7553.1, T, 300.0), 0.0) * 0.8 / 6; };
  EXPECT_NEAR(host_copy(box.dissolved)(left), 2 * at(310) + at(305), 1e-16);
  EXPECT_NEAR(host_copy(box.dissolved)(right), 2 * at(320) + at(325), 1e-16);
  EXPECT_EQ(host_copy(box.V)(left), 1 - host_copy(box.dissolved)(left));
  book_turnover(box.exec, box.surface, box.wall, box.links, ledger);
  EXPECT_EQ(host_copy(box.V)(left), 1 - host_copy(box.dissolved)(left)) << "booked once";
}

TEST(ReactiveWall, ALedRateIsTheMeanOverTheStepsToCome) {
  Box box = box_of({"...", ".#.", "..."}, 0.8);
  find_reactive_links<D2Q5>(box.exec, box.nodes, box.surface, box.wall.law, box.links);
  const auto conductance = [&](double k, double ahead) {
    set_conductances<D2Q5>(box.exec, box.nodes, box.surface, box.wall, uniform_rate(k), box.normal, box.links, ahead);
    return host_copy(box.links.conductance)(0);
  };
  const auto exact = [](double k) { return kinetic_conductance(k, 0.0); };
  EXPECT_EQ(conductance(0.010, 0), exact(0.010));
  // 0.010 at step 0, 0.012 at step 20: 0.0125 in the middle of the next ten, 0.013 of the next twenty
  EXPECT_DOUBLE_EQ(conductance(0.012, 0.25), exact(0.0125));
  conductance(0.010, 0);
  EXPECT_DOUBLE_EQ(conductance(0.012, 0.5), exact(0.013));
  // the change is that since the last call, not of what was led; and no more than half or double the rate
  EXPECT_DOUBLE_EQ(conductance(0.014, 0.5), exact(0.015));
  EXPECT_DOUBLE_EQ(conductance(0.001, 0.5), exact(0.0005));
  EXPECT_DOUBLE_EQ(conductance(0.100, 5), exact(0.2));
}

}  // namespace
}  // namespace vug
