#pragma once
// Prefetching of data that is read in an order that a processor cannot predict. A function that only prefetches must be
// inlined by force: GCC takes a call of it for one without effect and drops it.
#include "base/base.hpp"

namespace vug {

/// Prefetches the cache line of an address; does nothing on a GPU, where other threads hide the latency.
KOKKOS_FORCEINLINE_FUNCTION void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
  __builtin_prefetch(address);
#endif
}

/// The same into the second level of the caches only, for much further ahead. The first level can wait for only a dozen
/// lines at a time, which would limit the speed of a list of scattered places.
KOKKOS_FORCEINLINE_FUNCTION void prefetch_far([[maybe_unused]] const void* address) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
  __builtin_prefetch(address, 0, 2);
#endif
}

}  // namespace vug
