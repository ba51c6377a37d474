// Births of fluid nodes on lattices small enough to follow by hand.
#include "kernels/reaction/dissolution.hpp"

#include "../reference/drawn_box.hpp"
#include "kernels/flow/guards.hpp"
#include "kernels/reaction/reactive_wall_kernel.hpp"
#include "support/dress_one.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

using reference::Box;
using reference::box_of;
using test::edit;
using test::host_copy;
using test::set_entry;

/// Solid that node (x, y) holds.
double solid(const Box& box, int x, int y) {
  return host_copy(box.V)(box.lattice.node(x, y));
}

void set_solid(const Box& box, int x, int y, double V) {
  set_entry(box.V, box.lattice.node(x, y), V);
}

void set_concentration(const Box& box, int x, int y, double C) {
  const int i = host_copy(box.nodes.index)(box.lattice.node(x, y));
  edit(box.acid.h, [&](const auto& h) {
    for (int q = 0; q < 5; ++q) h(q * box.nodes.capacity + i) = D2Q5::w(q) * C;
  });
}

double concentration(const Box& box, int x, int y) {
  const int i = host_copy(box.nodes.index)(box.lattice.node(x, y));
  const auto h = host_copy(box.acid.h);
  double C = 0;
  for (int q = 0; q < 5; ++q) C += h(q * box.nodes.capacity + i);
  return C;
}

TEST(MarkDissolved, TakesTheOverdraftFromTheSolidNeighboursInEqualShares) {
  Box box = box_of({"####", "####", "..##"});
  set_solid(box, 2, 0, -0.25);
  EXPECT_EQ(mark_dissolved(box.exec, box.nodes, box.surface, box.type, box.V, box.lost), 1);
  EXPECT_EQ(host_copy(box.type)(box.lattice.node(2, 0)), NodeType::fluid);
  EXPECT_EQ(solid(box, 2, 0), 0);
  for (const auto& [x, y] : {std::pair{3, 0}, {1, 1}, {2, 1}, {3, 1}}) EXPECT_EQ(solid(box, x, y), 1 - 0.25 / 4);
  EXPECT_EQ(solid(box, 0, 1), 1);
  EXPECT_EQ(box.solid_total(), 8.75);
  EXPECT_EQ(sum_in_order(box.lost), 0);
}

TEST(MarkDissolved, SeveralPixelsMayShareAnHeir) {
  Box box = box_of({"....", "####", "...."});
  for (const int x : {0, 2}) set_solid(box, x, 1, -0.125);
  set_solid(box, 3, 1, 0);
  EXPECT_EQ(mark_dissolved(box.exec, box.nodes, box.surface, box.type, box.V, box.lost), 3);
  EXPECT_EQ(solid(box, 1, 1), 0.75);
  EXPECT_EQ(box.solid_total(), 0.75);
}

TEST(MarkDissolved, WritesDownWhatNoSolidIsLeftToPay) {
  Box box = box_of({"...", ".#.", "..."});
  set_solid(box, 1, 1, -0.25);
  EXPECT_EQ(mark_dissolved(box.exec, box.nodes, box.surface, box.type, box.V, box.lost), 1);
  EXPECT_EQ(box.solid_total(), 0);
  EXPECT_EQ(sum_in_order(box.lost), -0.25);
}

TEST(MarkDissolved, TakesTheOverdraftFromTheSameMineralOnly) {
  Box box = box_of({"####", "####", "..##"});
  const Kokkos::View<std::uint8_t*> mineral("mineral", box.lattice.size());
  const MineralLosses losses{
      mineral, {ScalarField<double>("lost", box.lost.extent(0)), ScalarField<double>("lost", box.lost.extent(0))}};
  for (const auto& [x, y] : {std::pair{2, 0}, {3, 0}, {1, 1}}) set_entry(mineral, box.lattice.node(x, y), 1);
  set_solid(box, 2, 0, -0.25);
  EXPECT_EQ(mark_dissolved(box.exec, box.nodes, box.surface, box.type, box.V, box.lost, losses), 1);
  for (const auto& [x, y] : {std::pair{3, 0}, {1, 1}}) EXPECT_EQ(solid(box, x, y), 1 - 0.25 / 2);
  for (const auto& [x, y] : {std::pair{2, 1}, {3, 1}, {0, 1}}) EXPECT_EQ(solid(box, x, y), 1);
  EXPECT_EQ(sum_in_order(box.lost), 0);
  append_births(box.exec, box.type, box.nodes);
  find_surface(box.exec, box.nodes, box.type, box.surface);
  set_entry(mineral, box.lattice.node(1, 1), 0);
  set_solid(box, 3, 0, -0.125);  // the last of its mineral around here
  mark_dissolved(box.exec, box.nodes, box.surface, box.type, box.V, box.lost, losses);
  EXPECT_EQ(solid(box, 2, 1), 1);
  EXPECT_EQ(sum_in_order(box.lost), -0.125);
  EXPECT_EQ(sum_in_order(losses.lost[0]), 0);
  EXPECT_EQ(sum_in_order(losses.lost[1]), -0.125);
}

TEST(MarkDissolved, LeavesThePixelsThatStillHoldSolid) {
  Box box = box_of({"###", "#.#", "###"});
  set_solid(box, 0, 1, 1e-300);
  EXPECT_EQ(mark_dissolved(box.exec, box.nodes, box.surface, box.type, box.V, box.lost), 0);
  EXPECT_EQ(solid(box, 0, 1), 1e-300);
}

TEST(Births, MeanIsThatOfTheOldNeighboursAndIsWrittenDown) {
  Box box = box_of({"###", ".#.", "#.#"});
  set_concentration(box, 0, 1, 0.1);
  set_concentration(box, 2, 1, 0.4);
  set_concentration(box, 1, 0, 0.7);
  set_solid(box, 1, 1, 0);
  EXPECT_EQ(box.births(BirthFill::mean), 1);
  EXPECT_NEAR(concentration(box, 1, 1), 0.4, 1e-15);
  EXPECT_NEAR(sum_in_order(box.created), 0.4, 1e-15);
}

TEST(Births, SplitSharesWhatTheOldNeighboursHave) {
  Box box = box_of({"###", ".#.", "#.#"});
  set_concentration(box, 0, 1, 0.1);
  set_concentration(box, 2, 1, 0.4);
  set_concentration(box, 1, 0, 0.7);
  set_solid(box, 1, 1, 0);
  EXPECT_EQ(box.births(BirthFill::split), 1);
  EXPECT_NEAR(concentration(box, 1, 1), 0.3, 1e-15);
  EXPECT_NEAR(concentration(box, 1, 0), 0.525, 1e-15);
  EXPECT_NEAR(box.acid_total(), 1.2, 1e-15);
  EXPECT_EQ(sum_in_order(box.created), 0);
}

TEST(Births, ManyAroundOneNodeLeaveItsShareAndNothingNegative) {
  Box box = box_of({"###", "#.#", "###"});
  set_concentration(box, 1, 1, 1);
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {2, 1}, {1, 2}}) set_solid(box, x, y, 0);
  EXPECT_EQ(box.births(BirthFill::split), 4);
  EXPECT_NEAR(concentration(box, 1, 1), 0.2, 1e-15);
  EXPECT_NEAR(concentration(box, 2, 1), 0.2, 1e-15);
  EXPECT_NEAR(box.acid_total(), 1, 1e-15);
}

TEST(Births, NewbornsDoNotSeeEachOther) {
  // the right one touches only the left newborn and begins empty
  for (const BirthFill fill : {BirthFill::mean, BirthFill::split}) {
    Box box = box_of({"####", ".###", "####"}, 0.6);
    set_solid(box, 1, 1, 0);
    set_entry(box.type, box.lattice.node(2, 1), NodeType::fluid);  // opened by a fracture at the same moment
    set_solid(box, 2, 1, 0);
    EXPECT_EQ(box.births(fill), 2);
    EXPECT_EQ(concentration(box, 2, 1), 0);
    EXPECT_NEAR(concentration(box, 1, 1), fill == BirthFill::mean ? 0.6 : 0.3, 1e-15);
  }
}

TEST(Births, AnIslandSeenOnlyAcrossACornerBeginsEmpty) {
  Box box = box_of({"##", ".#"}, 0.6);
  set_entry(box.type, box.lattice.node(1, 1), NodeType::fluid);
  set_solid(box, 1, 1, 0);
  set_solid(box, 1, 0, 0.5);
  const int first = box.nodes.count;
  ASSERT_EQ(append_births(box.exec, box.type, box.nodes), 1);
  fit_solute_to_capacity<D2Q5>(box.exec, box.nodes, first, box.acid);
  initialise_births<D2Q5>(box.exec, box.nodes, first, box.nodes.count, BirthFill::mean, box.acid, box.created);
  EXPECT_EQ(concentration(box, 1, 1), 0);
  EXPECT_EQ(sum_in_order(box.created), 0);
}

TEST(Births, ASolidThatVanishesAltogetherLeavesOnlyFluid) {
  Box box = box_of({"....", ".##.", "...."}, 1);
  box.k = 0.5;
  const double start = box.acid_total() - box.solid_total();
  for (int n = 0; n < 200; ++n) {
    box.step();
    box.births(BirthFill::split);
  }
  EXPECT_EQ(box.surface.count, 0);
  EXPECT_EQ(box.nodes.count, 12);
  EXPECT_EQ(box.solid_total(), 0);
  EXPECT_NEAR(box.acid_total(), start + sum_in_order(box.lost), 1e-13);
  EXPECT_LT(sum_in_order(box.lost), 0);
}

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
    set_conductances<D2Q5>(box.exec, box.nodes, box.surface, box.wall, UniformRate{k}, box.normal, box.links, ahead);
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

TEST(FieldRange, FindsExtremesAndTheFirstEntryThatIsNotFinite) {
  ScalarField<float> field("field", 2000);
  Kokkos::deep_copy(field, 0.5f);
  set_entry(field, 700, -3);
  set_entry(field, 1500, 7);
  FieldRange range = field_range(Exec{}, field, 2000);
  EXPECT_EQ(range.min, -3);
  EXPECT_EQ(range.max, 7);
  EXPECT_EQ(range.first_outside, -1);
  set_entry(field, 900, std::numeric_limits<float>::quiet_NaN());
  set_entry(field, 800, std::numeric_limits<float>::infinity());
  range = field_range(Exec{}, field, 2000);
  EXPECT_EQ(range.first_outside, 800);
  EXPECT_EQ(range.max, 7);
}

}  // namespace
}  // namespace vug
