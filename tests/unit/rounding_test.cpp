// Sums that are right in the mean over many steps.
#include "kernels/scalar/rounding.hpp"

#include "kernels/packs/pack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace vug {
namespace {

float last_place(float a) {
  return std::nextafter(std::abs(a), std::numeric_limits<float>::infinity()) - std::abs(a);
}

const std::vector<float> numbers{1.1F, 1.0F, 0.5F, -0.5F, -3.3F, std::nextafter(2.0F, 0.0F), 1e-6F, 7e20F};
const std::vector<double> parts{0.0, 1e-3, -0.1, 0.3, 0.45, -0.7, 1.3, 5.25};  // of the last place

constexpr int items = 64;

TEST(Rounding, HasTheExactMean) {
  for (const float a : numbers)
    for (const double part : parts) {
      const float b = static_cast<float>(part) * last_place(a);
      const int n = 4096;
      double gained = 0;
      for (int step = 0; step < n; ++step)
        for (int item = 0; item < items; ++item)
          gained += double(rounding_of_step<float>(step).at_nodes.sum(a, b, item)) - double(a);
      EXPECT_NEAR(gained / n / items / double(last_place(a)), part, 2e-3) << a;
    }
}

/// Most of b leaves again with c, as populations do: what is between them is below the last place of both.
TEST(Rounding, KeepsASmallPartBesideALargeOne) {
  for (const float a : numbers)
    for (const double part : {1e-3, -0.1, 0.3}) {
      const float large = 0.07F * a, small = static_cast<float>(part) * last_place(large);
      ASSERT_EQ(large + small, large);
      const int n = 4096;
      double gained = 0;
      for (int step = 0; step < n; ++step)
        for (int item = 0; item < items; ++item)
          gained += double(rounding_of_step<float>(step).at_nodes.sum(a, large, small, item)) - double(a);
      const double exact = double(large) + double(small);
      EXPECT_NEAR(gained / n / items, exact, 2e-3 * double(last_place(a))) << a << " and " << part;
    }
}

TEST(Rounding, LosesNothingOfWhatIsBelowTheLastPlace) {
  const int n = 20000;
  for (const float a : numbers)
    for (const double part : parts) {
      const float b = static_cast<float>(part) * last_place(a);
      double mean = 0;
      for (int item = 0; item < items; ++item) {
        float grown = a;
        for (int step = 0; step < n; ++step) grown = rounding_of_step<float>(step).at_links.sum(grown, b, item);
        mean += double(grown) / items;
      }
      const double exact = double(a) + n * double(b), walk = 0.5 * std::sqrt(n / items);
      EXPECT_NEAR(mean, exact, (part == 0 ? 0 : 4 * walk) * double(last_place(static_cast<float>(exact))))
          << a << " and " << part;
    }
}

TEST(Rounding, LeavesExactSumsAlone) {
  for (int step = 0; step < 1000; ++step) {
    const Rounding<float> rounding = rounding_of_step<float>(step).at_nodes;
    for (const float a : numbers) {
      EXPECT_EQ(rounding.sum(a, 0.0F, step), a);
      EXPECT_EQ(rounding.sum(a, -a, step), 0.0F);
      EXPECT_EQ(rounding.sum(a, a, step), 2 * a);
    }
  }
}

TEST(Rounding, IsAnOrdinarySumInDoublePrecision) {
  for (int step = 0; step < 100; ++step) {
    EXPECT_EQ(rounding_of_step<double>(step).at_nodes.sum(1.1, 0.3e-16, step), 1.1 + 0.3e-16);
    EXPECT_EQ(rounding_of_step<double>(step).at_nodes.sum(1.1, 0.2, 0.3e-16, step), 1.1 + 0.2 + 0.3e-16);
  }
}

TEST(Rounding, IsToTheNearestByDefault) {
  for (int item = 0; item < items; ++item) {
    EXPECT_EQ(Rounding<float>{}.sum(1.1F, 0.49F * last_place(1.1F), item), 1.1F);
    EXPECT_EQ(Rounding<float>{}.sum(1.1F, 0.51F * last_place(1.1F), item), 1.1F + last_place(1.1F));
  }
}

/// Largest distance of sorted shifts from those that divide (-1/2, 1/2) evenly.
double unevenness(std::vector<double> shifts) {
  std::sort(shifts.begin(), shifts.end());
  const double n = static_cast<double>(shifts.size());
  double largest = 0;
  for (std::size_t k = 0; k < shifts.size(); ++k)
    largest = std::max(largest, std::abs(shifts[k] - ((static_cast<double>(k) + 0.5) / n - 0.5)));
  return largest;
}

TEST(Rounding, ShiftsByAllPartsOfTheLastPlace) {
  for (const int item : {0, 1, 1000000}) {
    std::vector<double> nodes, links;
    for (int step = 0; step < 10000; ++step) {
      const StepRounding<float> rounding = rounding_of_step<float>(step);
      nodes.push_back(double(rounding.at_nodes.shift<float>(item)));
      links.push_back(double(rounding.at_links.shift<float>(item)));
    }
    EXPECT_LT(unevenness(nodes), 0.02);  // 5 / (2 sqrt(10000)) is 0.025
    EXPECT_LT(unevenness(links), 0.02);
  }
  for (int step = 0; step < 100; ++step) {
    std::vector<double> neighbours;
    for (int item = 0; item < 100; ++item)
      neighbours.push_back(double(rounding_of_step<float>(step).at_nodes.shift<float>(5000 + item)));
    EXPECT_LT(unevenness(neighbours), 0.03);
  }
}

/// Mean of the population at rest, from 0.3, where a population q becomes after[q] from before[q]; then what `exact`
/// arithmetic makes of it.
template <class Set>
std::pair<double, double> mean_of_rest(const float (&before)[Set::Q], const float (&after)[Set::Q], float added) {
  const int n = 1000;
  double mean = 0, exact = double(0.3F) + double(added);
  for (int q = 1; q < Set::Q; ++q) exact -= double(after[q]) - double(before[q]);
  for (int step = 0; step < n; ++step)
    for (int node = 0; node < items; ++node) {
      RestPopulation<float, Set, float> rest(0, added);
      for (int q = 1; q < Set::Q; ++q) rest.change(q, before[q], after[q], 0);
      mean += double(rest.of_sum(0.3F, rounding_of_step<float>(step).at_nodes, node)) / n / items;
    }
  return {mean, exact};
}

TEST(RestPopulation, ConservesTheSumOfPopulationsInTheMean) {
  for (const float added : {0.0F, 3e-9F}) {
    const auto [mean, exact] =
        mean_of_rest<D2Q5>({0, 0.1F, 0.1F, 0.1F, 0.1F}, {0, 0.1F + 7e-9F, 0.09999F, 0.1F, 0.1F}, added);
    EXPECT_NEAR(mean, exact, 1e-10);
  }
  RestPopulation<double, D2Q5, double> exact(0.5, 0);
  exact.change(1, 0.1, 0.3, 0.2);
  EXPECT_EQ(exact.of_sum(0.3, {}, 0), 0.5 - 0.2);
  EXPECT_EQ(exact.of_gain(0.3, {}, 0), 0.3 + (0.5 - 0.2));
}

/// Populations that exchange 0.05 in every step, while 1e-9 is added: nothing of it is lost among them.
TEST(RestPopulation, KeepsWhatIsAddedBesideLargeChanges) {
  const float added = 1e-9F;
  ASSERT_EQ(added - (0.15F - 0.1F), 0.1F - 0.15F);
  const auto [mean, exact] = mean_of_rest<D2Q5>({0, 0.1F, 0.1F, 0.15F, 0.1F}, {0, 0.15F, 0.1F, 0.1F, 0.1F}, added);
  EXPECT_NEAR(mean, exact, 0.1 * double(added));
}

/// In a steep gradient what flows through is far larger than what remains, and differently rounded in each direction.
TEST(RestPopulation, AddsWhatFlowsThroughByPairs) {
  float before[D2Q9::Q], after[D2Q9::Q];
  for (int q = 0; q < D2Q9::Q; ++q) {
    const double along = 0.3 * D2Q9::c(q, 0) + 0.2 * D2Q9::c(q, 1), w = D2Q9::w(q);
    before[q] = static_cast<float>(w * (0.66 - along));
    after[q] = static_cast<float>(w * (0.66 + along));
  }
  const auto [mean, exact] = mean_of_rest<D2Q9>(before, after, 0);
  EXPECT_NEAR(mean, exact, 1e-10);
}

#if !defined(__CUDACC__) && !defined(__HIPCC__)
TEST(Rounding, OfPacksIsThatOfNumbers) {
  float a[pack_size], b[pack_size];
  for (int l = 0; l < pack_size; ++l) {
    a[l] = numbers[l];
    b[l] = static_cast<float>(parts[l]) * last_place(a[l]);
  }
  for (int step = 0; step < 100; ++step) {
    const Rounding<float> rounding = rounding_of_step<float>(step).at_nodes;
    const Pack<float> sum = rounding.sum(PackOf<float>::load(a), PackOf<float>::load(b), 77 * step);
    for (int l = 0; l < pack_size; ++l) EXPECT_EQ(sum[l], rounding.sum(a[l], b[l], 77 * step + l));
  }
}
#endif

}  // namespace
}  // namespace vug
