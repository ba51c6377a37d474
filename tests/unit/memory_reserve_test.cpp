// How a process ends that has no memory left, each in a process of its own.
#include "host/memory_reserve.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <sys/resource.h>

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // which take address space without end

namespace vug {
namespace {

/// Leaves this process no more than a few MiB of address space beyond what it has.
void limit_memory() {
  long pages = 0;
  if (std::FILE* sizes = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(sizes, "%ld", &pages) != 1) pages = 0;
    std::fclose(sizes);
  }
  const rlim_t bytes = static_cast<rlim_t>(pages) * 4096 + (8u << 20);
  const struct rlimit limit { bytes, bytes };
  if (pages == 0 || ::setrlimit(RLIMIT_AS, &limit) != 0) std::_Exit(99);
}

/// Takes all memory there is, by malloc, down to the last bytes.
void take_the_rest() {
  for (std::size_t size = 1 << 20; size >= 16; size /= 2)
    while (void* volatile kept = std::malloc(size)) static_cast<void>(kept);
}

TEST(MemoryReserve, IsThereForTheErrorThatMemoryHasRunOut) {
  const auto runs_out = [] {
    limit_memory();
    if (!reserve_memory()) std::_Exit(98);
    take_the_rest();
    try {
      double* volatile more = new double;  // volatile, because a compiler may leave out both
      delete more;
    } catch (const std::bad_alloc&) {
      std::_Exit(std::malloc(64u << 10) ? 7 : 8);  // room to say why
    }
    std::_Exit(9);
  };
  EXPECT_EXIT(runs_out(), testing::ExitedWithCode(7), "");
}

TEST(MemoryReserve, EndsAProcessThatCannotThrow) {
  const auto ends = [] {
    limit_memory();
    if (!reserve_memory()) std::_Exit(98);
    take_the_rest();
    std::terminate();  // as the library calls it where an exception finds no room
  };
  EXPECT_EXIT(ends(), testing::ExitedWithCode(5), "^vug: out of memory: [^\n]*\n$");
}

TEST(MemoryReserve, LeavesOtherEndsAsTheyAre) {
  const auto ends = [] {
    if (!reserve_memory()) std::_Exit(98);
    std::terminate();
  };
  EXPECT_EXIT(ends(), testing::KilledBySignal(SIGABRT), "");
}

TEST(MemoryReserve, IsAskedForBeforeTheLibrariesTakeTheirs) {
  require_spare_memory();
  const auto runs_out = [] {
    limit_memory();
    take_the_rest();
    try {
      require_spare_memory();
    } catch (const std::bad_alloc&) {
      std::_Exit(7);
    }
    std::_Exit(8);
  };
  EXPECT_EXIT(runs_out(), testing::ExitedWithCode(7), "");
  const auto nothing_to_reserve = [] {
    limit_memory();
    take_the_rest();
    std::_Exit(reserve_memory() ? 8 : 7);
  };
  EXPECT_EXIT(nothing_to_reserve(), testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace vug

#endif
