// Which error ends a process with which exit code, and the line that says why.
#include "host/exit_code.hpp"

#include "base/require.hpp"
#include "host/free_memory.hpp"
#include "host/interruption.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace vug {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(ExitCode, IsThatOfTheError) {
  EXPECT_EQ(exit_code_of(InputError("a")), 2);
  EXPECT_EQ(exit_code_of(StabilityError("a")), 3);
  EXPECT_EQ(exit_code_of(FileError("a")), 4);
  EXPECT_EQ(exit_code_of(std::filesystem::filesystem_error("a", std::error_code())), 4);
  EXPECT_EQ(exit_code_of(MemoryError("a")), 5);
  const auto none = std::make_error_code(std::errc::not_enough_memory);
  EXPECT_EQ(exit_code_of(std::filesystem::filesystem_error("a", "b", none)), 5);
  EXPECT_EQ(exit_code_of(std::bad_alloc()), 5);
  EXPECT_EQ(exit_code_of(std::runtime_error("Kokkos failed to allocate 8 B")), 5);
  EXPECT_EQ(exit_code_of(Interrupted("a")), 130);
}

TEST(ExitCode, OfWhatNobodyForesawIsOne) {
  EXPECT_EQ(exit_code_of(std::logic_error("a")), 1);
  EXPECT_EQ(exit_code_of(std::length_error("a")), 1);
  EXPECT_EQ(exit_code_of(std::runtime_error("a")), 1);
  EXPECT_EQ(exit_code_of(std::system_error(std::error_code())), 1);
  EXPECT_EQ(exit_code_of(std::exception()), 1);
  EXPECT_EQ(reason_of(std::logic_error("vector::at")), "an error of vug itself: vector::at");
}

TEST(ExitCode, HasALineThatSaysWhy) {
  for (const char* words : {"a.toml:1:2: no", "flow diverged"}) {
    EXPECT_EQ(reason_of(InputError(words)), words);
    EXPECT_EQ(reason_of(StabilityError(words)), words);
    EXPECT_EQ(reason_of(FileError(words)), words);
    EXPECT_EQ(reason_of(MemoryError(words)), words);
    EXPECT_EQ(reason_of(Interrupted(words)), words);
  }
  const auto full = std::make_error_code(std::errc::no_space_on_device);
  EXPECT_EQ(reason_of(std::filesystem::filesystem_error("x", "out/a", full)), "out/a: No space left on device");
  EXPECT_EQ(reason_of(std::filesystem::filesystem_error("x", full)), "the current folder: No space left on device");
  EXPECT_EQ(reason_of(std::filesystem::filesystem_error("x", "a", "b", full)),
            "a: cannot copy to b: No space left on device");
  EXPECT_THAT(reason_of(std::bad_alloc()), AllOf(StartsWith("out of memory: "), HasSubstr("had been taken")));
  EXPECT_THAT(reason_of(std::runtime_error("Kokkos failed to allocate 8 B")),
              AllOf(StartsWith("out of memory: Kokkos failed to allocate 8 B; "), HasSubstr("had been taken")));
}

}  // namespace
}  // namespace vug
