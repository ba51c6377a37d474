// A build with VUG_SEPARATE_MEMORY ends where the host touches what a kernel alone may (tests/separate_memory).
#include "kernels/launch/launch.hpp"
#include "support/host_copy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace vug {
namespace {

class SeparateMemory : public testing::Test {
 protected:
  void SetUp() override {
#ifndef VUG_SEPARATE_MEMORY
    GTEST_SKIP() << "the host's memory is that of Views";
#endif
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
  }
};
using SeparateMemoryDeathTest = SeparateMemory;

TEST_F(SeparateMemoryDeathTest, EndsWhereTheHostReadsOrWritesAView) {
  const ScalarField<double> field("field", 1000);
  EXPECT_DEATH(field(3) = 1, "the host touches a device's memory");
  EXPECT_DEATH(std::printf("%g", field(999)), "the host touches a device's memory");
}

TEST_F(SeparateMemory, LetsKernelsCopiesAndMirrorsAlone) {
  const auto field = to_device<ScalarField<double>>("field", {1, 2, 4});
  const auto copy = on_host(field);
  copy(0) = 8;
  EXPECT_EQ(sum_in_order(field), 7) << "a mirror is a copy";
  test::set_entry(field, 0, 8);
  EXPECT_EQ(sum_in_order(field), 14);
}

TEST_F(SeparateMemory, ComesFullOfNan) {
  const ScalarField<double> field(Kokkos::view_alloc(Kokkos::WithoutInitializing, "field"), 10);
  EXPECT_TRUE(std::isnan(on_host(field)(7)));
}

}  // namespace
}  // namespace vug
