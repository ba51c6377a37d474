#pragma once
// Numbers too small to be normal.
#include "kernels/base/base.hpp"
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace vug {

/// Subnormal numbers cost a hundred times a normal one and carry nothing here: flushed to zero on every thread. For the
/// beginning of a program, once Kokkos runs.
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
