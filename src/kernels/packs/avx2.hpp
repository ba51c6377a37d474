#pragma once
// Packs on hosts with AVX2, whose registers hold eight floats or four doubles.
#include "kernels/packs/portable.hpp"

#if defined(__AVX2__) && !(defined(__AVX512F__) && defined(__AVX512VL__)) && !defined(VUG_PORTABLE_PACKS)
#include <array>
#include <immintrin.h>

namespace vug {

namespace detail {

/// Sets all bits of lane l where bit l of `lanes` is set.
inline __m256i mask_of_eight(std::uint32_t lanes) {
  const __m256i bit = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  return _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(static_cast<int>(lanes)), bit), bit);
}
inline __m256i mask_of_four(std::uint32_t lanes) {
  const __m256i bit = _mm256_setr_epi64x(1, 2, 4, 8);
  return _mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(lanes), bit), bit);
}

/// (lanes) One byte for each lane: how many of `lanes` lie before it. This is the number of the value that spread()
/// puts there.
inline constexpr auto ranks_in_lanes = [] {
  std::array<std::uint64_t, 256> ranks{};
  for (unsigned lanes = 0; lanes < 256; ++lanes)
    for (unsigned l = 0, rank = 0; l < 8; rank += lanes >> l & 1, ++l) ranks[lanes] |= std::uint64_t{rank} << 8 * l;
  return ranks;
}();

}  // namespace detail

template <>
struct PackOf<float> : PortablePack<float, 32> {
  using PortablePack::first, PortablePack::load, PortablePack::store;

  static Pack load(const float* p, std::uint32_t lanes) { return _mm256_maskload_ps(p, detail::mask_of_eight(lanes)); }
  static void store(float* p, std::uint32_t lanes, const Pack& v) {
    _mm256_maskstore_ps(p, detail::mask_of_eight(lanes), v);
  }
  static bool any_above(const Pack& a, const Pack& b) {
    return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_GT_OQ)) != 0;
  }
  static Pack blend(std::uint32_t lanes, const Pack& a, const Pack& b) {
    return _mm256_blendv_ps(a, b, _mm256_castsi256_ps(detail::mask_of_eight(lanes)));
  }
  static Pack spread(std::uint32_t lanes, const float* p) {
    const __m256i rank = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<long long>(detail::ranks_in_lanes[lanes])));
    const __m256 spread = _mm256_permutevar8x32_ps(load(p, first(lanes)), rank);
    return _mm256_and_ps(spread, _mm256_castsi256_ps(detail::mask_of_eight(lanes)));
  }
};

template <>
struct PackOf<double> : PortablePack<double, 32> {
  using PortablePack::first, PortablePack::load, PortablePack::store;

  static Pack load(const double* p, std::uint32_t lanes) {
    return {_mm256_maskload_pd(p, detail::mask_of_four(lanes)),
            _mm256_maskload_pd(p + 4, detail::mask_of_four(lanes >> 4))};
  }
  static void store(double* p, std::uint32_t lanes, const Pack& v) {
    _mm256_maskstore_pd(p, detail::mask_of_four(lanes), v.low);
    _mm256_maskstore_pd(p + 4, detail::mask_of_four(lanes >> 4), v.high);
  }
  static bool any_above(const Pack& a, const Pack& b) {
    const __m256d low = _mm256_cmp_pd(a.low, b.low, _CMP_GT_OQ), high = _mm256_cmp_pd(a.high, b.high, _CMP_GT_OQ);
    return _mm256_movemask_pd(_mm256_or_pd(low, high)) != 0;
  }
  static Pack blend(std::uint32_t lanes, const Pack& a, const Pack& b) {
    return {_mm256_blendv_pd(a.low, b.low, _mm256_castsi256_pd(detail::mask_of_four(lanes))),
            _mm256_blendv_pd(a.high, b.high, _mm256_castsi256_pd(detail::mask_of_four(lanes >> 4)))};
  }
  static Pack spread(std::uint32_t lanes, const double* p) {
    const double* const next = p + Kokkos::Experimental::popcount_builtin(lanes & 15);
    return {spread_four(lanes & 15, p), spread_four(lanes >> 4 & 15, next)};
  }

 private:
  static __m256d spread_four(std::uint32_t lanes, const double* p) {
    const __m256d numbers = _mm256_maskload_pd(p, detail::mask_of_four(first(lanes)));
    const auto ranks = static_cast<int>(detail::ranks_in_lanes[lanes]);
    const __m256i low = _mm256_slli_epi64(_mm256_cvtepu8_epi64(_mm_cvtsi32_si128(ranks)), 1);  // halves of numbers
    const __m256i both = _mm256_or_si256(low, _mm256_slli_epi64(_mm256_or_si256(low, _mm256_set1_epi64x(1)), 32));
    const __m256 spread = _mm256_permutevar8x32_ps(_mm256_castpd_ps(numbers), both);
    return _mm256_and_pd(_mm256_castps_pd(spread), _mm256_castsi256_pd(detail::mask_of_four(lanes)));
  }
};

}  // namespace vug
#endif
