// The solute side on lattices small enough to follow by hand.
#include "kernels/solute/solute.hpp"

#include "../reference/reactive_box.hpp"

#include <gtest/gtest.h>

namespace vug {
namespace {

using reference::ReactiveBox;

template <class Set>
class DissolvingSlab : public ::testing::Test {};
using VelocitySets = ::testing::Types<D2Q5, D2Q9>;
TYPED_TEST_SUITE(DissolvingSlab, VelocitySets);

TYPED_TEST(DissolvingSlab, AcidAndSolidBalanceThroughBirths) {
  for (const BirthFill fill : {BirthFill::mean, BirthFill::split}) {
    ReactiveBox<TypeParam, double> box(12, 3, [](int x, int) { return x >= 6; }, solute_parameters(0.1), 1.0,
                                       {false, true});
    box.k = 0.05;
    box.wall.molar_volume = 0.7;
    const double start = box.acid_total() - box.solid_total() / 0.7;
    int born = 0;
    for (int n = 0; n < 4000; ++n) {
      box.step();
      born += box.births(fill);
    }
    const double end = box.acid_total() - box.solid_total() / 0.7;
    const double created = sum_in_order(box.created), lost = sum_in_order(box.lost);
    // acid only leaves by taking its share of solid with it; what a birth creates or overdraws is on the ledger.
    // 4000 steps of sums of order 20 round to about 1e-13 each
    EXPECT_NEAR(end, start + created + lost / 0.7, 2e-12);
    EXPECT_EQ(lost, 0);
    EXPECT_EQ(born % 3, 0);
    EXPECT_GE(born, 3);
    EXPECT_EQ(created > 0, fill == BirthFill::mean);
    EXPECT_NEAR(sum_in_order(box.dissolved), 18 - box.solid_total(), 1e-12);
    EXPECT_NEAR(sum_in_order(box.consumed) * 0.7, sum_in_order(box.dissolved), 1e-12);
  }
}

TEST(SoluteSweep, FloatNeitherGainsNorLosesSolute) {
  ReactiveBox<D2Q5, float> box(
      16, 16, [](int x, int y) { return (x / 4 + y / 4) % 3 == 0; }, solute_parameters(0.02f), 0.7);
  ReactiveBox<D2Q9, float> nine(
      16, 16, [](int x, int y) { return (x / 4 + y / 4) % 3 == 0; }, solute_parameters(0.02f, 0.7), 0.7);
  const double before = box.acid_total(), before_nine = nine.acid_total();
  for (int n = 0; n < 20000; ++n) {
    box.step();
    nine.step();
  }
  // a systematic loss of half a unit in the last place per step would come to 6e-4
  EXPECT_NEAR(box.acid_total() / before, 1, 2e-6);
  EXPECT_NEAR(nine.acid_total() / before_nine, 1, 2e-6);
}

}  // namespace
}  // namespace vug
