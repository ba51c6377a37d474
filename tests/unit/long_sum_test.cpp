// Sums over a run of a million steps.
#include "kernels/launch/long_sum.hpp"

#include "kernels/launch/launch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

struct Add {
  double amount;
  ScalarField<double> sum;
  KOKKOS_FUNCTION void operator()(int i) const { sum(i) += amount; }
};

TEST(LongSum, KeepsWhatAMillionRoundingsWouldTake) {
  const int steps = 1000000;
  const double amount = 0.1, exact = static_cast<double>(static_cast<long double>(amount) * steps);
  LongSum sum("sum", 1);
  double plain = 0;
  for (int step = 0; step < steps; ++step) {
    plain += amount;
    for_each_node(Exec{}, "add", 1, Add{amount, sum.recent()});
    if ((step + 1) % LongSum::interval == 0) sum.settle(Exec{});
  }
  EXPECT_GT(std::abs(plain / exact - 1), 1e-12) << "the sum should need it";
  // within an interval amounts are added plainly: 1024 roundings of half a digit
  EXPECT_LT(std::abs(sum.total() / exact - 1), 1024 * 1.1e-16 / 2);
}

TEST(LongSum, MovesAmountsOfAnySizeWithoutLoss) {
  LongSum sum("sum", 2);
  for (const double amount : {1.0, 1e20, 3.0, -1e20}) {
    Kokkos::deep_copy(sum.recent(), amount);
    sum.settle(Exec{});
  }
  EXPECT_EQ(sum.total(), 8);
}

TEST(LongSum, GrowsWithoutForgetting) {
  LongSum sum("sum", 1);
  Kokkos::deep_copy(sum.recent(), 2.0);
  sum.settle(Exec{});
  sum.resize(Exec{}, 3);
  Kokkos::deep_copy(sum.recent(), 0.5);
  EXPECT_EQ(sum.total(), 3.5);
}

}  // namespace
}  // namespace vug
