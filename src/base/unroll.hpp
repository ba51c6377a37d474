#pragma once
// Loops over the directions of a velocity set must be unrolled: only then does the loop over nodes around them
// vectorise, and only then do tables of directions fold to constants instead of being written to the stack in every
// iteration.
#include "base/base.hpp"

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

/// For a lambda inside a kernel: a call that is not inlined keeps a loop over nodes from vectorising.
#define VUG_INLINED __attribute__((always_inline))

namespace vug {

/// A number as a type: like std::integral_constant, whose conversion cannot be called on a device.
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
