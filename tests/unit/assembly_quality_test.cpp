// Which triangulations can be used as rock, and what is said of those that cannot.
#include "io/assembly_quality.hpp"

#include "base/require.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace vug {
namespace {

using ::testing::HasSubstr;

TEST(AssemblyQuality, FindsEveryKindOfUnusableRock) {
  const Assembly square{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}, {}};
  const auto quality = assembly_quality(square);
  EXPECT_DOUBLE_EQ(quality.area, 1);
  EXPECT_NEAR(quality.min_angle, 45, 1e-12);
  EXPECT_DOUBLE_EQ(quality.min_area_share, 1);
  EXPECT_DOUBLE_EQ(quality.mean_edge, (4 + std::sqrt(2)) / 5);
  EXPECT_NO_THROW(require_usable(square, {}, "square"));

  auto inverted = square;
  std::swap(inverted.triangles[0][1], inverted.triangles[0][2]);
  auto doubled = square;
  doubled.triangles.push_back({0, 1, 2});
  auto apart = square;
  apart.vertices.insert(apart.vertices.end(), {{2, 0}, {3, 0}, {3, 1}});
  apart.triangles.push_back({4, 5, 6});
  auto needle = square;
  needle.vertices[1] = {0.5, 0.45};
  for (const auto& [bad, word] : std::vector<std::pair<Assembly, std::string>>{{inverted, "clockwise"},
                                                                               {doubled, "edges"},
                                                                               {apart, "pieces"},
                                                                               {needle, "angle"},
                                                                               {Assembly{}, "no triangles"}}) {
    try {
      require_usable(bad, {}, "rock.mesh");
      FAIL() << word << " accepted";
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr(word));
      EXPECT_THAT(e.what(), HasSubstr("rock.mesh"));
    }
  }
}

}  // namespace
}  // namespace vug
