// How fast the rock may age beside the fluid (accuracy.dissolution_tolerance), number by number; runs are in
// scenes/slow_scenes_test.cpp.
#include "coupling/ageing_module.hpp"
#include "coupling/output_schedule.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug {
namespace {

TEST(NextFactor, KeepsWhatWasSeenBelowTheToleranceAndAtMostDoubles) {
  EXPECT_EQ(next_factor(8, 0, 1e-2), 16);        // nothing is wrong
  EXPECT_EQ(next_factor(8, 1e-2, 1e-2), 6);      // of the error allowed three quarters are used
  EXPECT_EQ(next_factor(8, 0.75e-2, 1e-2), 8);   // just right
  EXPECT_EQ(next_factor(8, 1e-3, 1e-2), 16);     // at most doubles
  EXPECT_EQ(next_factor(8, 1, 1e-2), 1);         // never slower than the fluid
  EXPECT_EQ(next_factor(8, INFINITY, 1e-2), 1);  // nothing is known
  EXPECT_EQ(next_factor(8e5, 0, 1e-2), largest_factor);
}

TEST(FactorBefore, RockGoesThroughEveryMomentAtTheFactorOne) {
  EXPECT_EQ(factor_before({}, 5, 0.1), largest_factor);
  EXPECT_EQ(factor_before({5}, 5, 0.1), largest_factor);  // it lies behind
  EXPECT_DOUBLE_EQ(factor_before({5, 25}, 5, 0.1), 199);  // one look is left before it
  const std::vector<double> moments{2, 2.05, 8};
  double age = 0;
  for (int looks = 0; age < 10; ++looks) {
    const double factor = factor_before(moments, age, 0.1), until = age + 0.1 * std::min(factor, 20.0);
    for (const double moment : moments) {
      const bool passed = moment > age && moment <= until;
      EXPECT_TRUE(!passed || factor == 1) << moment;
    }
    age = until;
    ASSERT_LT(looks, 40);
  }
}

/// A table of every kind, and one at each place where there may be tables; the later ones have the earlier times.
TEST(FactorBefore, KnowsTheTablesOfEveryValueAtEveryBoundary) {
  double next = 100;
  std::vector<double> times;
  const auto table = [&] {
    next -= 3;
    times.insert(times.end(), {next, next + 1});
    return TimeTable({next, next + 1}, {1, 2});
  };
  Scene scene;
  BoundarySection& left = scene.left;
  left.flow.pressure = table();
  left.flow.velocity = {table(), table()};
  left.flow.speed = table();
  left.flow.flow_rate = table();
  left.flow.mass_flow_rate = table();
  left.heat.temperature = table();
  left.heat.flux = table();
  left.solute.concentration["A"] = table();
  left.solute.flux["B"] = table();
  scene.right.flow.pressure = table();
  scene.bottom.heat.temperature = table();
  scene.top.solute.concentration["A"] = table();
  scene.injections.resize(2);
  for (InjectionSection& injection : scene.injections) injection.conditions.flow.flow_rate = table();
  scene.openings.resize(2);
  for (OpeningSection& opening : scene.openings) opening.conditions.flow.speed = table();
  std::ranges::sort(times);
  EXPECT_EQ(times.size(), 34);
  EXPECT_EQ(moments_of(scene), times);
}

TEST(ScheduleOfAgeingRock, IsDueWhenTheTimePassesAMultiple) {
  const Schedule by_steps(3, 0), by_time(1, 0.5);
  EXPECT_TRUE(by_steps.due({2, 0.1}, {3, 0.1}));
  EXPECT_FALSE(by_steps.due({3, 0.1}, {4, 0.1}));
  EXPECT_FALSE(by_time.due({4, 0.1, 0}, {5, 0.1, -0.01}));
  EXPECT_TRUE(by_time.due({4, 0.1, 0}, {5, 0.1, 0}));  // 0.1 5 is not quite 0.5
  EXPECT_TRUE(by_time.due({4, 0.1, 0}, {5, 0.1, 7}));
  EXPECT_FALSE(by_time.due({5, 0.1, 0}, {6, 0.1, 0}));
}

/// Multiples of an interval that is no whole number of steps do not drift.
TEST(ScheduleOfOutput, IsDueAfterTheStepNearestToEachMultiple) {
  const Schedule often(2.5e-3 / 3e-4, 0), closely(4.6e-4 / 3e-4, 0);
  std::vector<int> found, close;
  for (int step = 1; step <= 34; ++step) {
    if (often.due({step - 1, 3e-4}, {step, 3e-4})) found.push_back(step);
    if (step <= 9 && closely.due({step - 1, 3e-4}, {step, 3e-4})) close.push_back(step);
  }
  EXPECT_EQ(found, (std::vector<int>{8, 17, 25, 33}));     // 8.33, 16.67, 25, 33.33
  EXPECT_EQ(close, (std::vector<int>{2, 3, 5, 6, 8, 9}));  // 1.53, 3.07, 4.6, 6.13, 7.67, 9.2
}

/// With looks of our own making.
class Pace : public Ageing {
 public:
  explicit Pace(double tolerance) : Ageing(tolerance) {}
  using Ageing::Look;
  using Ageing::take_in;
  void step(const Exec&, const Clock&) override {}
  void tasks(std::vector<Task>&) const override {}
};

TEST(Ageing, PaceAndBoundFollowEveryLook) {
  Pace pace(1e-2);
  EXPECT_EQ(pace.factor(), 1);
  EXPECT_EQ(pace.error(), 0);  // nothing has dissolved

  // {dissolved, off the steady state, loss of a wall node, share of its age, still, steps}
  pace.take_in({2, 2e-3, 1e-3, 1e-3, true, 10});
  EXPECT_DOUBLE_EQ(pace.factor(), 2);  // at most doubles
  EXPECT_EQ(pace.error(), 0);          // the rock had not aged faster yet
  EXPECT_DOUBLE_EQ(pace.residual(), 2e-3);

  pace.take_in({1, 5e-3, 1e-3, 1e-3, true, 10});
  EXPECT_DOUBLE_EQ(pace.factor(), 3);  // 0.75 of the tolerance over what was seen
  EXPECT_DOUBLE_EQ(pace.error(),
                   0.5 * 5e-3 * 1 / 3);  // at the factor 2 half of what dissolved is more than was paid for

  pace.take_in({1, 1e-3, 1e-2, 2e-3, true, 10});  // a wall node is the first to complain
  EXPECT_DOUBLE_EQ(pace.factor(), 2.25);
  pace.take_in({1, 1e-3, 2e-3, 1.5e-2, true, 10});  // the age of the rock is
  EXPECT_DOUBLE_EQ(pace.factor(), 1.125);
  EXPECT_EQ(pace.waits(), 0);
  EXPECT_DOUBLE_EQ(pace.largest(), 3);

  const double before = pace.error() * 5;
  pace.take_in({1, 7, 0, 0, true, 10});  // acid breaks through: no more than all of it can be wrong
  EXPECT_EQ(pace.factor(), 1);
  EXPECT_EQ(pace.waits(), 1);
  EXPECT_DOUBLE_EQ(pace.error() * 6, before + (1 - 1 / 1.125));

  EXPECT_EQ(pace.waiting_steps(), 10);  // those of the first look
  pace.take_in({1, 0, 0, 0, false, 10});
  EXPECT_EQ(pace.factor(), 1) << "the flow moves";
  EXPECT_EQ(pace.waits(), 1) << "it waits already";
  EXPECT_EQ(pace.waiting_steps(), 20);
}

TEST(Ageing, WhereNothingReactsYetTheBoundStaysFinite) {
  Pace pace(1e-2);
  pace.take_in({1, 0, 0, 0, true, 1});
  pace.take_in({0, INFINITY, 0, 0, true, 1});  // nothing has dissolved though there is a wall
  EXPECT_EQ(pace.factor(), 1);
  EXPECT_EQ(pace.error(), 0);
  pace.take_in({0, 0, 0, 0, true, 1});
  EXPECT_EQ(pace.factor(), 2);
}

}  // namespace
}  // namespace vug
