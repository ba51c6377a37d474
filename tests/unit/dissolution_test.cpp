// Births of fluid nodes on lattices small enough to follow by hand.
#include "kernels/reaction/dissolution.hpp"

#include "../reference/drawn_box.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

using reference::Box;
using reference::box_of;
using reference::concentration;
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

TEST(SoluteBirths, MeanIsThatOfTheOldNeighboursAndIsWrittenDown) {
  Box box = box_of({"###", ".#.", "#.#"});
  set_concentration(box, 0, 1, 0.1);
  set_concentration(box, 2, 1, 0.4);
  set_concentration(box, 1, 0, 0.7);
  set_solid(box, 1, 1, 0);
  EXPECT_EQ(box.births(BirthFill::mean), 1);
  EXPECT_NEAR(concentration(box, 1, 1), 0.4, 1e-15);
  EXPECT_NEAR(sum_in_order(box.created), 0.4, 1e-15);
}

TEST(SoluteBirths, SplitSharesWhatTheOldNeighboursHave) {
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

TEST(SoluteBirths, ManyAroundOneNodeLeaveItsShareAndNothingNegative) {
  Box box = box_of({"###", "#.#", "###"});
  set_concentration(box, 1, 1, 1);
  for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {2, 1}, {1, 2}}) set_solid(box, x, y, 0);
  EXPECT_EQ(box.births(BirthFill::split), 4);
  EXPECT_NEAR(concentration(box, 1, 1), 0.2, 1e-15);
  EXPECT_NEAR(concentration(box, 2, 1), 0.2, 1e-15);
  EXPECT_NEAR(box.acid_total(), 1, 1e-15);
}

TEST(SoluteBirths, NewbornsDoNotSeeEachOther) {
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

TEST(SoluteBirths, AnIslandSeenOnlyAcrossACornerBeginsEmpty) {
  Box box = box_of({"##", ".#"}, 0.6);
  set_entry(box.type, box.lattice.node(1, 1), NodeType::fluid);
  set_solid(box, 1, 1, 0);
  set_solid(box, 1, 0, 0.5);
  const int first = box.nodes.count;
  ASSERT_EQ(append_births(box.exec, box.type, box.nodes), 1);
  fit_to_capacity(box.exec, box.nodes, D2Q5::Q, first, box.acid.h, box.acid.C);
  initialise_births<D2Q5>(box.exec, box.nodes, first, box.nodes.count, BirthFill::mean, box.acid, box.created);
  EXPECT_EQ(concentration(box, 1, 1), 0);
  EXPECT_EQ(sum_in_order(box.created), 0);
}

TEST(SoluteBirths, ASolidThatVanishesAltogetherLeavesOnlyFluid) {
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

}  // namespace
}  // namespace vug
