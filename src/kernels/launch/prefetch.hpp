#pragma once
// Telling a processor ahead what it will read in an order that it cannot foresee. A function that does nothing else
// must be inlined by force: GCC takes a call of it for one without effect and drops it.
#include "kernels/base/base.hpp"

namespace vug {

/// Asks for the cache line of an address; does nothing on a GPU, where other threads fill the wait.
KOKKOS_FORCEINLINE_FUNCTION void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
  __builtin_prefetch(address);
#endif
}

/// The same into the second level of the caches only, for much further ahead: the first level waits for a dozen lines
/// at a time and no more, which then is the speed of a list of scattered places.
KOKKOS_FORCEINLINE_FUNCTION void prefetch_far([[maybe_unused]] const void* address) {
#if defined(__GNUC__) && !defined(__CUDA_ARCH__) && !defined(__HIP_DEVICE_COMPILE__)
  __builtin_prefetch(address, 0, 2);
#endif
}

}  // namespace vug
