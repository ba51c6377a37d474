#pragma once
// Flushing of subnormal numbers.
#include "kernels/base/base.hpp"
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace vug {

/// Flushes subnormal numbers to zero on every thread: they cost a hundred times as much as normal ones and do not
/// matter here. To be called at the beginning of a program, once Kokkos runs.
inline void flush_subnormals() {
#if defined(__SSE2__)
  constexpr unsigned flush_and_zero = 0x8040;
  Kokkos::parallel_for(
      "vug::main::flush_subnormals",
      Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace>(0, Kokkos::DefaultHostExecutionSpace().concurrency()),
      [](int) { _mm_setcsr(_mm_getcsr() | flush_and_zero); });
  _mm_setcsr(_mm_getcsr() | flush_and_zero);
#endif
}

}  // namespace vug
