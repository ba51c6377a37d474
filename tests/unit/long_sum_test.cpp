// Sums over a run of a million steps.
#include "kernels/launch/long_sum.hpp"

#include "kernels/launch/launch.hpp"
#include "support/host_copy.hpp"
#include "support/overheard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace vug {
struct FillWithInverse {
  ScalarField<double> values;
  KOKKOS_FUNCTION void operator()(int i) const { values(i) = 1.0 / (1 + i); }
};

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

/// Bytes that the largest copy had since it was set to 0.
std::uint64_t largest_copy = 0;
const test::Overheard* overheard = nullptr;

TEST(SumInOrder, OfADenseFieldIsTakenWhereTheFieldIs) {
  constexpr int n = 200001;
  const ScalarField<double> values("values", n);
  for_each_node(Exec{}, "fill", n, FillWithInverse{values});
  const auto host = test::host_copy(values);
  long double expected = 0;
  for (int i = 0; i < n; ++i) expected += host(i);
  const test::Overheard others;
  overheard = &others;
  largest_copy = 0;
  Kokkos::Tools::Experimental::set_begin_deep_copy_callback(
      [](Kokkos::Profiling::SpaceHandle there, const char* to, const void* target, Kokkos::Profiling::SpaceHandle here,
         const char* from, const void* source, std::uint64_t size) {
        largest_copy = std::max(largest_copy, size);
        overheard->copied(there, to, target, here, from, source, size);
      });
  const double sum = sum_in_order(values);
  EXPECT_NEAR(sum, static_cast<double>(expected), 1e-13 * sum);
  EXPECT_LE(largest_copy, block_count(n) * sizeof(double));
  EXPECT_EQ(sum_in_order(values), sum);
}

}  // namespace
}  // namespace vug
