#include "host/memory.hpp"

#include "base/base.hpp"
#include "base/pages.hpp"
#include "host/memory_reserve.hpp"

#include <atomic>
#include <cstdint>
#include <cstring>

namespace vug {

namespace {

std::atomic<std::int64_t> bytes{0};

/// Size from which a field is large, bytes. A sweep reads some twenty arrays at once, and pages of 4 KiB cost it a
/// tenth of its speed or more.
constexpr std::uint64_t large = 4u << 20;

/// Kokkos calls this before anything is written to the memory. Fields take most of it, so that here is where it ends.
void allocated(Kokkos::Profiling::SpaceHandle space, const char*, const void* data, std::uint64_t size) {
  require_spare_memory();
  bytes += static_cast<std::int64_t>(size);
  if (size >= large && std::strcmp(space.name, Kokkos::HostSpace::name()) == 0)
    take_large_pages(const_cast<void*>(data), size);
}

void freed(Kokkos::Profiling::SpaceHandle, const char*, const void*, std::uint64_t size) {
  bytes -= static_cast<std::int64_t>(size);
}

}  // namespace

void watch_allocations() {
  Kokkos::Tools::Experimental::set_allocate_data_callback(allocated);
  Kokkos::Tools::Experimental::set_deallocate_data_callback(freed);
}

double allocated_bytes() {
  return static_cast<double>(bytes.load());
}

}  // namespace vug
