// What guards find in a field.
#include "kernels/flow/guards.hpp"

#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace vug {
namespace {

using test::set_entry;

TEST(FieldRange, FindsExtremesAndTheFirstEntryThatIsNotFinite) {
  ScalarField<float> field("field", 2000);
  Kokkos::deep_copy(field, 0.5f);
  set_entry(field, 700, -3);
  set_entry(field, 1500, 7);
  FieldRange range = field_range(Exec{}, field, 2000);
  EXPECT_EQ(range.min, -3);
  EXPECT_EQ(range.max, 7);
  EXPECT_EQ(range.first_outside, -1);
  set_entry(field, 900, std::numeric_limits<float>::quiet_NaN());
  set_entry(field, 800, std::numeric_limits<float>::infinity());
  range = field_range(Exec{}, field, 2000);
  EXPECT_EQ(range.first_outside, 800);
  EXPECT_EQ(range.max, 7);
}

}  // namespace
}  // namespace vug
