#pragma once
// Flushing of subnormal numbers.
#include "base/base.hpp"
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace vug {

/// On the calling thread; on processors other than x86-64 and 64-bit Arm nothing happens.
inline void flush_subnormals_of_this_thread() {
#if defined(__SSE2__)
  constexpr unsigned flush_and_zero = 0x8040;  // MXCSR: of results, of operands
  _mm_setcsr(_mm_getcsr() | flush_and_zero);
#elif defined(__aarch64__)
  constexpr unsigned long long flush = 1ull << 24;  // FPCR.FZ: of both
  unsigned long long control = 0;
  __asm__ __volatile__("mrs %0, fpcr" : "=r"(control));
  __asm__ __volatile__("msr fpcr, %0" : : "r"(control | flush));
#endif
}

/// Flushes subnormal numbers to zero on every thread: they cost a hundred times as much as normal ones and do not
/// matter here. To be called at the beginning of a program, once Kokkos runs.
inline void flush_subnormals() {
  Kokkos::parallel_for(
      "vug::main::flush_subnormals",
      Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace>(0, Kokkos::DefaultHostExecutionSpace().concurrency()),
      [](int) { flush_subnormals_of_this_thread(); });
  flush_subnormals_of_this_thread();
}

}  // namespace vug
