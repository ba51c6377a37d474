#pragma once
// Packs on hosts with AVX-512.
#include "kernels/packs/portable.hpp"

#if defined(__AVX512F__) && defined(__AVX512VL__) && !defined(VUG_PORTABLE_PACKS)
#include <immintrin.h>

namespace vug {

template <>
struct PackOf<double> : PortablePack<double, 64> {
  static constexpr bool permutes = true;
  using PortablePack::first, PortablePack::load, PortablePack::store;

  static Pack load(const double* p, std::uint32_t lanes) { return _mm512_maskz_loadu_pd(mask(lanes), p); }
  static void store(double* p, std::uint32_t lanes, const Pack& v) { _mm512_mask_storeu_pd(p, mask(lanes), v); }
  static void add_to(double (&sums)[pack_size], const Pack& v) { store(sums, load(sums) + v); }
  static bool any_above(const Pack& a, const Pack& b) { return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ) != 0; }
  static Pack blend(std::uint32_t lanes, const Pack& a, const Pack& b) {
    return _mm512_mask_blend_pd(mask(lanes), a, b);
  }
  static Pack spread(std::uint32_t lanes, const double* p) {
    return _mm512_maskz_expand_pd(mask(lanes), load(p, first(lanes)));
  }
  static Pack pick(std::uint32_t order, const Pack& a, const Pack& b) {
    return _mm512_permutex2var_pd(a, fields(order, 4), b);
  }
  static Pack pick(std::uint32_t order, const Pack& a) { return _mm512_maskz_permutexvar_pd(all, fields(order, 3), a); }

 private:
  static constexpr __mmask8 all = 0xff;  // for the masked forms: the others cause a false warning of GCC 12
  static __mmask8 mask(std::uint32_t lanes) { return static_cast<__mmask8>(lanes); }
  static __m512i fields(std::uint32_t order, int width) {
    const __m512i lane = _mm512_set_epi64(7 * width, 6 * width, 5 * width, 4 * width, 3 * width, 2 * width, width, 0);
    return _mm512_maskz_srlv_epi64(all, _mm512_set1_epi32(static_cast<int>(order)), lane);
  }
};

template <>
struct PackOf<float> : PortablePack<float, 32> {
  static constexpr bool permutes = true;
  using PortablePack::first, PortablePack::load, PortablePack::store;

  static Pack load(const float* p, std::uint32_t lanes) { return _mm256_maskz_loadu_ps(mask(lanes), p); }
  static void store(float* p, std::uint32_t lanes, const Pack& v) { _mm256_mask_storeu_ps(p, mask(lanes), v); }
  static void add_to(double (&sums)[pack_size], const Pack& v) {
    PackOf<double>::add_to(sums, __builtin_convertvector(v, PackOf<double>::Pack));
  }
  static bool any_above(const Pack& a, const Pack& b) { return _mm256_cmp_ps_mask(a, b, _CMP_GT_OQ) != 0; }
  static Pack blend(std::uint32_t lanes, const Pack& a, const Pack& b) {
    return _mm256_mask_blend_ps(mask(lanes), a, b);
  }
  static Pack spread(std::uint32_t lanes, const float* p) {
    return _mm256_maskz_expand_ps(mask(lanes), load(p, first(lanes)));
  }
  static Pack pick(std::uint32_t order, const Pack& a, const Pack& b) {
    return _mm256_permutex2var_ps(a, fields(order, 4), b);
  }
  static Pack pick(std::uint32_t order, const Pack& a) { return _mm256_permutevar8x32_ps(a, fields(order, 3)); }

 private:
  static __mmask8 mask(std::uint32_t lanes) { return static_cast<__mmask8>(lanes); }
  static __m256i fields(std::uint32_t order, int width) {
    const __m256i lane = _mm256_set_epi32(7 * width, 6 * width, 5 * width, 4 * width, 3 * width, 2 * width, width, 0);
    return _mm256_srlv_epi32(_mm256_set1_epi32(static_cast<int>(order)), lane);
  }
};

}  // namespace vug
#endif
