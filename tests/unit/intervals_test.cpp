// How long an interval may be, from what has changed and what a case says of it.
#include "coupling/amount_share.hpp"
#include "coupling/force_change.hpp"
#include "coupling/given_changes.hpp"
#include "coupling/interval_chooser.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

namespace vug {
namespace {

TEST(NextInterval, DoublesWhereThereIsRoomAndShrinksAtOnce) {
  EXPECT_EQ(next_interval(1, 16, 1e-4, 1e-3), 2);
  EXPECT_EQ(next_interval(4, 16, 1e-4, 1e-3), 4) << "8 steps would change it by 0.8 of what is allowed";
  EXPECT_EQ(next_interval(8, 16, 1e-4, 1e-3), 8) << "no back and forth";
  EXPECT_EQ(next_interval(16, 16, 1e-4, 1e-3), 8);
  EXPECT_EQ(next_interval(16, 16, 1e-3, 1e-3), 1);
  EXPECT_EQ(next_interval(16, 16, 1, 1e-3), 1) << "never less than a step";
  EXPECT_EQ(next_interval(16, 16, 0, 1e-3), 16);
  EXPECT_EQ(next_interval(8, 16, 0, 1e-3), 16);
  EXPECT_EQ(next_interval(16, 4, 0, 1e-3), 4) << "no longer than is stable";
  EXPECT_EQ(next_interval(16, 16, NAN, 1e-3), 1) << "what is not known is not held";
}

TEST(ShareOf, IsAllWhereThereIsNothingYet) {
  EXPECT_EQ(share_of(0, 0), 1);
  EXPECT_EQ(share_of(1, 4), 0.25);
}

TEST(AmountShare, IsNothingWhereThereIsExactlyNone) {
  EXPECT_EQ(amount_share(0, 0), 0);
  EXPECT_EQ(amount_share(1, 0), 1) << "all of it is gone";
  EXPECT_EQ(amount_share(1, 4), 0.25);
  EXPECT_EQ(amount_share(0, -1), 1) << "less than none";
  EXPECT_EQ(amount_share(NAN, NAN), 1);
}

TEST(Steepest, IsTheLargestSlopeInAStretch) {
  const TimeTable table({1, 2, 4, 5}, {0, 6, 4, 4});
  EXPECT_EQ(steepest(table, 0, 10), 6);
  EXPECT_EQ(steepest(table, 0, 1), 0) << "it begins at the end";
  EXPECT_EQ(steepest(table, 0, 1.1), 6);
  EXPECT_EQ(steepest(table, 2, 10), 1) << "it falls as well";
  EXPECT_EQ(steepest(table, 1.9, 2.1), 6);
  EXPECT_EQ(steepest(table, 4, 9), 0);
  EXPECT_EQ(steepest(TimeTable(3), 0, 10), 0);
}

/// Share by which given values change in ten steps of 0.1 s, of heat, solutes and forces.
std::vector<double> raised(const Scene& scene, std::int64_t step) {
  Changes changes;
  GivenChanges(scene).raise(changes, Clock{step, 0.1}, 10);
  EXPECT_EQ(changes.solid, 0);
  return {changes.heat, changes.solute, changes.force};
}

TEST(GivenChanges, AreThoseOfTheStepsToComeOverTheLargestDistanceFromRest) {
  const auto values = [](double heat, double solute, double force) { return std::vector<double>{heat, solute, force}; };
  Scene scene;
  scene.heat.emplace().initial_temperature = 300;
  scene.flow.emplace().initial_pressure = 100;
  scene.solute.emplace();
  scene.mechanics.emplace();
  EXPECT_EQ(raised(scene, 0), values(0, 0, 0));

  scene.left.heat.temperature = TimeTable({0, 4, 5}, {300, 300, 280});
  EXPECT_EQ(raised(scene, 0), values(0, 0, 0)) << "the steps end before";
  EXPECT_EQ(raised(scene, 40), values(1, 0, 0)) << "20 K in 1 s, of 20";
  EXPECT_EQ(raised(scene, 35), values(1, 0, 0)) << "at its steepest";
  EXPECT_EQ(raised(scene, 50), values(0, 0, 0)) << "it lies behind";
  scene.left.heat.temperature = TimeTable({0, 4, 5, 90, 91}, {300, 300, 280, 300, 2300});
  EXPECT_EQ(raised(scene, 40), values(1, 0, 0)) << "later rows hide no change";
  EXPECT_EQ(raised(scene, 900), values(1, 0, 0)) << "of 2000 K";
  scene.left.heat.temperature = {};

  scene.top.solute.concentration["A"] = TimeTable({0, 2}, {8, 2});
  EXPECT_EQ(raised(scene, 0), values(0, 0.375, 0)) << "3 per s, of 8";
  scene.top.solute.concentration.clear();
  scene.top.solute.flux["A"] = TimeTable({0, 2}, {0, -2});
  EXPECT_EQ(raised(scene, 0), values(0, 0.5, 0));
  scene.top.solute.flux.clear();
  scene.top.heat.flux = TimeTable({0, 4}, {0, 1});
  EXPECT_EQ(raised(scene, 0), values(0.25, 0, 0));
  scene.top.heat.flux = {};

  const TimeTable table({0, 4}, {100, 300});  // a half per s of 200 Pa, a sixth per s of 300
  scene.injections.resize(1);
  FlowBoundary& flow = scene.injections[0].conditions.flow;
  flow.pressure = table;
  EXPECT_EQ(raised(scene, 0), values(0.25, 0.25, 0.25)) << "the flow carries and pushes";
  flow.pressure = {};
  for (int kind = 0; kind < 5; ++kind) {
    FlowBoundary other;
    if (kind < 2) other.velocity[kind] = TimeTable({0, 4}, {1, 2});
    if (kind == 2) other.speed = TimeTable({0, 4}, {1, 2});
    if (kind == 3) other.flow_rate = TimeTable({0, 4}, {1, 2});
    if (kind == 4) other.mass_flow_rate = TimeTable({0, 4}, {1, 2});
    flow = other;
    EXPECT_EQ(raised(scene, 0), values(0.125, 0.125, 0.125)) << kind;
  }
  scene.mechanics.reset();
  scene.solute.reset();
  EXPECT_EQ(raised(scene, 0), values(0.125, 0, 0)) << "nothing else is held";
}

TEST(LongestIntervals, ArePowersOfTwoThatEndWithALook) {
  AccuracySection accuracy;
  accuracy.heat_interval = 7;
  accuracy.solute_interval = 200;
  accuracy.wall_interval = 1000;
  accuracy.exchange_interval = 3;
  accuracy.update_interval = 1;
  EXPECT_EQ(longest_intervals(accuracy), (Intervals{4, 128, 512, 2, 1}));
}

TEST(LargestForceChange, IsThatOfOneTriangleSinceTheLastCall) {
  const VectorField<double> force("force", 3), before("before", 3);
  const auto set = [&](std::initializer_list<double> xy) {
    const auto host = Kokkos::create_mirror_view(force);
    for (int k = 0; k < 6; ++k) host(k / 2, k % 2) = xy.begin()[k];
    Kokkos::deep_copy(force, host);
  };
  set({3, -4, 0, 1, -2, 0});
  const ForceChange first = largest_force_change(Exec{}, force, before),
                    again = largest_force_change(Exec{}, force, before);
  EXPECT_DOUBLE_EQ(first.change, 5);
  EXPECT_DOUBLE_EQ(first.force, 5);
  EXPECT_EQ(again.change, 0);
  EXPECT_DOUBLE_EQ(again.force, 5);
  set({3, -4, 6, 9, -2, 0});
  const ForceChange moved = largest_force_change(Exec{}, force, before);
  EXPECT_DOUBLE_EQ(moved.change, 10);
  EXPECT_DOUBLE_EQ(moved.force, std::hypot(6, 9));
}

}  // namespace
}  // namespace vug
