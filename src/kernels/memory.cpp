#include "kernels/memory.hpp"

#include "kernels/base.hpp"

#include <atomic>
#include <cstdint>

namespace vug {

namespace {

std::atomic<std::int64_t> bytes{0};

void allocated(Kokkos::Profiling::SpaceHandle, const char*, const void*, std::uint64_t size) {
  bytes += static_cast<std::int64_t>(size);
}

void freed(Kokkos::Profiling::SpaceHandle, const char*, const void*, std::uint64_t size) {
  bytes -= static_cast<std::int64_t>(size);
}

}  // namespace

void count_allocations() {
  Kokkos::Tools::Experimental::set_allocate_data_callback(allocated);
  Kokkos::Tools::Experimental::set_deallocate_data_callback(freed);
}

double allocated_bytes() {
  return static_cast<double>(bytes.load());
}

}  // namespace vug
