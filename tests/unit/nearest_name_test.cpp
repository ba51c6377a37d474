// What is asked back where a name is unknown.
#include "io/detail/nearest_name.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug {
namespace {

/// A column without its unit is that column, however long the unit is; a slip is the nearest name; the rest is neither.
TEST(NearestName, IsTheOneThatGoesOnOrTheClosest) {
  const std::vector<std::string> names{"time_s", "dissolved_volume_initial_m3_per_m", "dissolved_volume_m3_per_m",
                                       "reactive_area_m2_per_m"};
  EXPECT_EQ(likely_name("dissolved_volume", names), "; did you mean \"dissolved_volume_m3_per_m\"?");
  EXPECT_EQ(likely_name("Reactive_area", names), "; did you mean \"reactive_area_m2_per_m\"?");
  EXPECT_EQ(likely_name("time", names), "; did you mean \"time_s\"?");
  EXPECT_EQ(likely_name("tiem_s", names), "; did you mean \"time_s\"?");
  EXPECT_EQ(likely_name("reactive", names), "; did you mean \"reactive_area_m2_per_m\"?");
  EXPECT_EQ(likely_name("dissolved_vol", names), "");
  EXPECT_EQ(suggestion("porosity", std::vector<std::string>{"a_1", "b_1"}), "; valid are a_1, b_1");
}

}  // namespace
}  // namespace vug
