#pragma once
// Registers of eight numbers on hosts with AVX-512.
#include "kernels/base/base.hpp"

#include <cstdint>

#if defined(__AVX512F__) && defined(__AVX512VL__) && !defined(__CUDACC__) && !defined(__HIPCC__)
#define VUG_EIGHT_LANES
#include <immintrin.h>
#endif

namespace vug {

#ifdef VUG_EIGHT_LANES
inline constexpr bool has_eight_lanes = runs_on_host;
#else
inline constexpr bool has_eight_lanes = false;
#endif

inline constexpr int eight_lanes = 8;

/// Registers of eight numbers.
template <class T>
struct Eight;

#ifdef VUG_EIGHT_LANES
template <>
struct Eight<double> {
  typedef double Register __attribute__((vector_size(64)));  // with operators, as __m512d
  static Register load(const double* p) { return _mm512_loadu_pd(p); }
  static Register load(const double* p, std::uint32_t lanes) {
    return _mm512_maskz_loadu_pd(static_cast<__mmask8>(lanes), p);
  }
  static void store(double* p, Register v) { _mm512_storeu_pd(p, v); }
  static void store(double* p, std::uint32_t lanes, Register v) {
    _mm512_mask_storeu_pd(p, static_cast<__mmask8>(lanes), v);
  }
  /// Adds each lane to its sum.
  static void add_to(double (&sums)[eight_lanes], Register v) { store(sums, load(sums) + v); }
  /// Whether some lane of `a` is above that of `b`.
  static bool any_above(Register a, Register b) { return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ) != 0; }
  /// Lane l: `b` where bit l of `lanes` is set, else `a`.
  static Register blend(std::uint32_t lanes, Register a, Register b) {
    return _mm512_mask_blend_pd(static_cast<__mmask8>(lanes), a, b);
  }
  /// The lanes of `a`, one after the other, at those whose bit is set in `lanes`; zero at others.
  static Register spread(std::uint32_t lanes, Register a) {
    return _mm512_maskz_expand_pd(static_cast<__mmask8>(lanes), a);
  }
  /// Lane l: number (order >> 4 l) % 16 of the sixteen in `a` and `b`.
  static Register pick(std::uint32_t order, Register a, Register b) {
    return _mm512_permutex2var_pd(a, fields(order, 4), b);
  }
  /// Lane l: number (order >> 3 l) % 8 of `a`.
  static Register pick(std::uint32_t order, Register a) {
    return _mm512_maskz_permutexvar_pd(all, fields(order, 3), a);
  }

 private:
  static constexpr __mmask8 all = 0xff;  // the forms with a mask: the others draw a false warning from GCC 12
  static __m512i fields(std::uint32_t order, int width) {
    const __m512i lane = _mm512_set_epi64(7 * width, 6 * width, 5 * width, 4 * width, 3 * width, 2 * width, width, 0);
    return _mm512_maskz_srlv_epi64(all, _mm512_set1_epi32(static_cast<int>(order)), lane);
  }
};

template <>
struct Eight<float> {
  typedef float Register __attribute__((vector_size(32)));
  static Register load(const float* p) { return _mm256_loadu_ps(p); }
  static Register load(const float* p, std::uint32_t lanes) {
    return _mm256_maskz_loadu_ps(static_cast<__mmask8>(lanes), p);
  }
  static void store(float* p, Register v) { _mm256_storeu_ps(p, v); }
  static void store(float* p, std::uint32_t lanes, Register v) {
    _mm256_mask_storeu_ps(p, static_cast<__mmask8>(lanes), v);
  }
  static void add_to(double (&sums)[eight_lanes], Register v) {
    Eight<double>::add_to(sums, __builtin_convertvector(v, Eight<double>::Register));
  }
  static bool any_above(Register a, Register b) { return _mm256_cmp_ps_mask(a, b, _CMP_GT_OQ) != 0; }
  static Register blend(std::uint32_t lanes, Register a, Register b) {
    return _mm256_mask_blend_ps(static_cast<__mmask8>(lanes), a, b);
  }
  static Register spread(std::uint32_t lanes, Register a) {
    return _mm256_maskz_expand_ps(static_cast<__mmask8>(lanes), a);
  }
  static Register pick(std::uint32_t order, Register a, Register b) {
    return _mm256_permutex2var_ps(a, fields(order, 4), b);
  }
  static Register pick(std::uint32_t order, Register a) { return _mm256_permutevar8x32_ps(a, fields(order, 3)); }

 private:
  static __m256i fields(std::uint32_t order, int width) {
    const __m256i lane = _mm256_set_epi32(7 * width, 6 * width, 5 * width, 4 * width, 3 * width, 2 * width, width, 0);
    return _mm256_srlv_epi32(_mm256_set1_epi32(static_cast<int>(order)), lane);
  }
};
#endif

/// The number at `from`, or where V is a register those of eight neighbours.
template <class V, class T>
KOKKOS_FORCEINLINE_FUNCTION V fetch(const T* from) {
  if constexpr (sizeof(V) == sizeof(T))
    return *from;
  else
    return Eight<T>::load(from);
}
/// Leaves it, or them, there.
template <class V, class T>
KOKKOS_FORCEINLINE_FUNCTION void put(T* to, const V& value) {
  if constexpr (sizeof(V) == sizeof(T))
    *to = value;
  else
    Eight<T>::store(to, value);
}

}  // namespace vug
