#include "dem/heterogeneity.hpp"
#include "dem_support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace {

using namespace vug;
using vug::test::host_copy;

constexpr std::uint64_t draws = 100000;
constexpr double shape = 7;

std::vector<double> sample(std::uint64_t seed, BondProperty property) {
  std::vector<double> w;
  for (std::uint64_t k = 0; k < draws; ++k) {
    w.push_back(weibull_of_mean_one(uniform_of(seed, k, k + 1, static_cast<std::uint64_t>(property)), shape));
  }
  return w;
}

TEST(Weibull, HasMeanOneAndTheSpreadOfItsShape) {
  double mean = 0, square = 0;
  for (const double w : sample(1, BondProperty::cohesion)) {
    mean += w / draws;
    square += w * w / draws;
  }
  // population CV 0.1680; the mean of 1e5 draws scatters by 0.168 / sqrt(1e5) = 5.3e-4, here four times that
  EXPECT_NEAR(mean, 1, 2.2e-3);
  EXPECT_NEAR(std::sqrt(square - mean * mean), 0.1680, 2e-3);
}

TEST(Weibull, PassesKolmogorovSmirnov) {
  std::vector<double> w = sample(3, BondProperty::normal_strength);
  std::sort(w.begin(), w.end());
  const double scale = 1 / std::tgamma(1 + 1 / shape);
  double distance = 0;
  for (std::size_t k = 0; k < w.size(); ++k) {
    const double f = 1 - std::exp(-std::pow(w[k] / scale, shape));
    distance = std::max({distance, f - static_cast<double>(k) / draws, static_cast<double>(k + 1) / draws - f});
  }
  EXPECT_LT(distance, 1.628 / std::sqrt(static_cast<double>(draws)));  // p = 0.01
}

TEST(Weibull, PropertiesOfOneBondAreIndependent) {
  const auto a = sample(1, BondProperty::cohesion), b = sample(1, BondProperty::energy_I),
             c = sample(2, BondProperty::cohesion);
  double ab = 0, ac = 0;
  for (std::size_t k = 0; k < draws; ++k) {
    ab += (a[k] - 1) * (b[k] - 1) / draws / (0.168 * 0.168);
    ac += (a[k] - 1) * (c[k] - 1) / draws / (0.168 * 0.168);
  }
  // correlation of independent samples scatters by 1 / sqrt(1e5) = 3.2e-3
  EXPECT_NEAR(ab, 0, 0.013);
  EXPECT_NEAR(ac, 0, 0.013);
}

TEST(Weibull, StrengthBelongsToTheEdgeAndNotToTheOrderOfTriangles) {
  const Assembly forward = test::block(0.02, 0.02, 2e-3, 0.2);
  Assembly backward = forward;
  std::reverse(backward.triangles.begin(), backward.triangles.end());
  std::vector<std::pair<std::pair<int, int>, double>> strength[2];
  const Assembly* assembly[2] = {&forward, &backward};
  for (int way = 0; way < 2; ++way) {
    const Bonds bonds = make_bonds(*assembly[way], make_particles(*assembly[way], {}), {});
    const auto vertex = host_copy(bonds.vertex);
    const auto cohesion = host_copy(bonds.cohesion);
    for (int k = 0; k < bonds.count; ++k) {
      strength[way].push_back({std::minmax({vertex(k, 0), vertex(k, 1)}), cohesion(k)});
    }
    std::sort(strength[way].begin(), strength[way].end());
  }
  EXPECT_EQ(strength[0], strength[1]);
}

TEST(Weibull, ShapeZeroSwitchesTheScatterOff) {
  EXPECT_EQ(weibull_of_mean_one(0.3, 0), 1);
}

}  // namespace
