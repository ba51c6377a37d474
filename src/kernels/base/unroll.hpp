#pragma once
// Loops over the directions of a velocity set must be unrolled before the loop over nodes around them can vectorise,
// and for the tables of directions to fold to constants: else each round writes its table to the stack.
#include "kernels/base/base.hpp"

#include <utility>

#if defined(__CUDACC__) || defined(__HIPCC__)
#define VUG_UNROLL _Pragma("unroll")
#elif defined(__clang__)
#define VUG_UNROLL _Pragma("clang loop unroll(full)")
#elif defined(__GNUC__)
#define VUG_UNROLL _Pragma("GCC unroll 9")
#else
#define VUG_UNROLL
#endif

/// On a lambda inside a kernel: a call left standing in a loop over nodes keeps the loop from vectorising.
#define VUG_INLINED __attribute__((always_inline))

namespace vug {

/// A number that the type carries: std::integral_constant, whose conversion is not for the device.
template <int k>
struct Constant {
  KOKKOS_FORCEINLINE_FUNCTION constexpr operator int() const { return k; }
};

/// Calls body(Constant<k>) for k = 0 .. N-1 in order, so that tables indexed by k fold to constants.
template <int N, class Body>
KOKKOS_FORCEINLINE_FUNCTION constexpr void unroll(const Body& body) {
  [&]<int... k>(std::integer_sequence<int, k...>) VUG_INLINED {
    (body(Constant<k>{}), ...);
  }
  (std::make_integer_sequence<int, N>{});
}

}  // namespace vug
