// What a run reports where its walls lose more rock than they have: the surface follows too late, or rock dissolves
// that was not there.
#include "support/watched.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug {
namespace {

using test::Watched;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string& slab = test::slab_in_acid;
const std::string late = "warning: a wall node has lost more rock between two looks than a cell holds";
const std::string too_much = "warning: more rock has dissolved than there was";

std::string every(int steps) {
  return "accuracy.update_interval=" + std::to_string(steps);
}

/// Share of the dissolved volume that no node had.
double overdrawn(const Watched& run) {
  return run.now("solid_volume_gain_overdrawn_m3_per_m") / run.now("dissolved_volume_stored_m3_per_m");
}

/// Thirteen cells of rock, of which two are lost between two looks: its neighbours below have what a node lacks.
TEST(RockLoss, FromTheNeighboursIsLateAndNotTooMuch) {
  Watched run(slab, {"geometry.shapes.0.to=[20e-6, 13e-6]", "lattice.size=[20e-6, 20e-6]", every(1500)});
  EXPECT_THAT(run.steps(3000), ElementsAre(AllOf(HasSubstr(late), HasSubstr("the surface follows too late; lower "
                                                                            "accuracy.update_interval"))));
  EXPECT_EQ(overdrawn(run), 0);
}

/// One layer of rock, of which three quarters are lost between two looks.
TEST(RockLoss, OfAThinLayerIsTooMuchAndNotLate) {
  Watched run(slab, {"geometry.shapes.0.to=[20e-6, 1e-6]", "lattice.size=[20e-6, 20e-6]", every(800)});
  const std::vector<std::string> news = run.steps(3000);
  EXPECT_GT(overdrawn(run), 0.2);
  ASSERT_THAT(news, ElementsAre(AllOf(HasSubstr(too_much), HasSubstr("% so far): lower accuracy.update_interval"))));
  EXPECT_THAT(Events(run.simulation(), news).look(run.simulation()), IsEmpty()) << "after a restart as well";
  EXPECT_THAT(Events(run.simulation(), {}).look(run.simulation()), ElementsAre(HasSubstr(too_much)))
      << "known from the state of a checkpoint";
}

TEST(RockLoss, IsSmallWhereLooksAreOften) {
  Watched run(slab, {every(1)});
  EXPECT_THAT(run.steps(5000), IsEmpty());
  EXPECT_EQ(run.now("solid_volume_stored_m3_per_m"), 0) << "all has dissolved";
}

/// No look in the whole run: what exceeds all rock is too much.
TEST(RockLoss, IsKnownBeforeTheFirstLook) {
  Watched run(slab, {every(1000000)});
  EXPECT_THAT(run.steps(5000), ElementsAre(HasSubstr(late), HasSubstr(too_much)));
}

/// What was lost before the last look is remembered.
TEST(RockLoss, IsReportedAfterTheLook) {
  Watched run(slab, {every(3000)});
  run.pass(3000);
  EXPECT_THAT(run.steps(1), testing::Contains(HasSubstr(late)));
}

}  // namespace
}  // namespace vug
