#pragma once
// The discrete velocity sets. D2Q5 is the first five directions of D2Q9, so one table of neighbours serves both.
#include "base/base.hpp"
#include "base/choices.hpp"
#include "base/unroll.hpp"

namespace vug {

/// Nine velocities in two dimensions (paper Eqs. 16, 17): rest, four along the axes, four diagonal.
struct D2Q9 {
  static constexpr int Q = 9;
  // Tables are packed into integers: where q is known only at run time, arrays would be written to the stack at every
  // call.

  /// Component `axis` (0 = x, 1 = y) of velocity q, in nodes per step.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int c(int q, int axis) {
    // c + 1 in two bits each: x = 0 1 0 -1 0 1 -1 -1 1, y = 0 0 1 0 -1 1 1 -1 -1
    constexpr unsigned x = 0x20919, y = 0x2865;
    return static_cast<int>((axis == 0 ? x : y) >> (2 * q) & 3U) - 1;
  }
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int opposite(int q) {
    constexpr unsigned long long digits = 0x658721430;  // 0 3 4 1 2 7 8 5 6, last digit first
    return static_cast<int>(digits >> (4 * q) & 15U);
  }
  /// Weight of velocity q: 4/9, 1/9, 1/36.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr double w(int q) {
    return q == 0 ? 4.0 / 9.0 : q < 5 ? 1.0 / 9.0 : 1.0 / 36.0;
  }
};

/// Five velocities in two dimensions for scalars: rest and the four along the axes.
struct D2Q5 {
  static constexpr int Q = 5;
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int c(int q, int axis) { return D2Q9::c(q, axis); }
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int opposite(int q) { return D2Q9::opposite(q); }
  /// Weight of velocity q: 1/3, 1/6.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr double w(int q) { return q == 0 ? 1.0 / 3.0 : 1.0 / 6.0; }
};

/// c_q . (x, y) for either set; without multiplications and added zeros where q is a constant to the compiler.
template <class V>
KOKKOS_FORCEINLINE_FUNCTION constexpr V along(int q, const V& x, const V& y) {
  const int cx = D2Q9::c(q, 0), cy = D2Q9::c(q, 1);
  if (cx == 0 && cy == 0) return V{};
  if (cy == 0) return cx > 0 ? x : -x;
  if (cx == 0) return cy > 0 ? y : -y;
  return (cx > 0 ? x : -x) + (cy > 0 ? y : -y);
}

/// Sum of the populations of a node in type V: that at `rest` and those at multiples of `plane` entries behind it.
template <class Set, class V, class T>
KOKKOS_FORCEINLINE_FUNCTION V sum_of_populations(const T* rest, int plane) {
  V sum = static_cast<V>(*rest);
  VUG_UNROLL
  for (int q = 1; q < Set::Q; ++q) sum += static_cast<V>(rest[q * plane]);
  return sum;
}

/// Returns visit(D2Q5{}) or visit(D2Q9{}), according to `set`.
template <class Visit>
auto visit_velocity_set(ScalarVelocitySet set, const Visit& visit) {
  return set == ScalarVelocitySet::d2q9 ? visit(D2Q9{}) : visit(D2Q5{});
}

/// Square of the lattice speed of sound of both sets.
inline constexpr double c_s2 = 1.0 / 3.0;

}  // namespace vug
