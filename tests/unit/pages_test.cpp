#include "base/pages.hpp"

#include "host/memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>

namespace vug {
namespace {

constexpr std::size_t mebi = 1 << 20;

/// Bytes of large pages in the mapping that holds an address, after proc(5).
std::size_t bytes_in_large_pages(const void* address) {
  const auto at = reinterpret_cast<std::uintptr_t>(address);
  std::ifstream smaps("/proc/self/smaps");
  bool inside = false;
  for (std::string line; std::getline(smaps, line);) {
    std::istringstream words(line);
    std::string first;
    words >> first;
    if (const auto dash = first.find('-'); dash != std::string::npos) {
      inside = std::stoull(first.substr(0, dash), nullptr, 16) <= at &&
               at < std::stoull(first.substr(dash + 1), nullptr, 16);
    } else if (inside && first == "AnonHugePages:") {
      std::size_t kibi = 0;
      words >> kibi;
      return kibi * 1024;
    }
  }
  return 0;
}

using Bytes = Kokkos::View<char*, Kokkos::HostSpace>;

/// Whether the system grants large pages at all, to memory that nobody had before.
bool are_granted() {
  const Bytes fresh(Kokkos::view_alloc("fresh", Kokkos::WithoutInitializing), 256 * mebi);
  take_large_pages(fresh.data(), fresh.size());
  std::memset(fresh.data(), 1, fresh.size());
  return bytes_in_large_pages(fresh.data() + fresh.size() / 2) >= fresh.size() / 2;
}

/// Where memory was that has been written and given back.
std::uintptr_t use_and_give_back(std::size_t size) {
  const Bytes memory("used", size);
  return reinterpret_cast<std::uintptr_t>(memory.data());
}

/// A heap keeps what was given back to it, in the small pages that it had, and hands it out once more.
TEST(Pages, OfALargeFieldAreLargeWhereOthersHaveBeenBefore) {
  if (!are_granted()) GTEST_SKIP() << "no large pages on this system";
  constexpr std::size_t size = 12 * mebi;
  use_and_give_back(2 * size);  // from then on the heap keeps as much
  const std::uintptr_t before = use_and_give_back(size + mebi);
  watch_allocations();  // from here on as a run does
  const Bytes field("field", size);
  const auto at = reinterpret_cast<std::uintptr_t>(field.data());
  if (std::max(at, before) - std::min(at, before) > mebi) GTEST_SKIP() << "this heap takes other memory";
  EXPECT_GE(bytes_in_large_pages(field.data() + size / 2), size / 2);
  EXPECT_EQ(std::count(field.data(), field.data() + size, 0), static_cast<std::ptrdiff_t>(size));
}

}  // namespace
}  // namespace vug
