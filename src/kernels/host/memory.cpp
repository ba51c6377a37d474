#include "kernels/host/memory.hpp"

#include "kernels/base/base.hpp"

#include <atomic>
#include <cstdint>
#include <cstring>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace vug {

namespace {

std::atomic<std::int64_t> bytes{0};

/// Asks for pages of 2 MiB where a field is large: a sweep walks through some twenty arrays at once, and pages of 4 KiB
/// cost it a tenth of its speed. A wish: where the system does not grant it nothing changes.
void wish_large_pages(const Kokkos::Profiling::SpaceHandle& space, const void* data, std::uint64_t size) {
#if defined(MADV_HUGEPAGE)
  constexpr std::uint64_t large = 2u << 20, small = 4096;
  if (size < 2 * large || std::strcmp(space.name, Kokkos::HostSpace::name()) != 0) return;
  const auto first = reinterpret_cast<std::uintptr_t>(data);
  const std::uintptr_t begin = (first + small - 1) / small * small, end = (first + size) / small * small;
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);
#else
  (void)space, (void)data, (void)size;
#endif
}

void allocated(Kokkos::Profiling::SpaceHandle space, const char*, const void* data, std::uint64_t size) {
  bytes += static_cast<std::int64_t>(size);
  wish_large_pages(space, data, size);
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
