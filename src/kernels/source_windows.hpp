#pragma once
// Eight fluid nodes at a time on hosts with AVX-512. Walls apart, the slots from which eight consecutive nodes pull one
// direction lie within sixteen consecutive ones, almost always (99 % in rock of three-node pathways): two loads and a
// permutation of registers then take the place of eight loads, a permutation and masked stores that of eight stores.
// The processor's own gathers and scatters are no faster than single loads and stores.
#include "kernels/base.hpp"
#include "kernels/unroll.hpp"
#include "kernels/velocity_set.hpp"

#include <cstdint>

#if defined(__AVX512F__) && defined(__AVX512VL__) && !defined(__CUDACC__) && !defined(__HIPCC__)
#define VUG_EIGHT_LANES
#include <immintrin.h>
#endif

namespace vug {

#ifdef VUG_EIGHT_LANES
inline constexpr bool has_source_windows = runs_on_host;
#else
inline constexpr bool has_source_windows = false;
#endif

inline constexpr int nodes_per_window = 8;

/// Where eight consecutive nodes, the first a multiple of eight, pull one direction from: FluidNodes::source of them
/// once more, in 20 bytes instead of 32.
struct SourceWindow {
  static constexpr int slots = 16;
  int first = -1;             ///< first slot of the window; -1: the slots lie too far apart for one
  std::uint32_t from = 0;     ///< 4 bits per node: its slot, counted from the first
  std::uint32_t to[2] = {};   ///< per half of the window: 3 bits per slot, its node; bit 24 + slot: has one
  std::uint32_t bounced = 0;  ///< bit per node: pulls from its own opposite slot instead

  static constexpr int owned_from = 24;
};

/// The window over eight entries of FluidNodes::source of one direction, whose slots are [plane, plane + capacity).
KOKKOS_INLINE_FUNCTION SourceWindow source_window(const int* source, int plane, int capacity) {
  SourceWindow w;
  int first = plane + capacity - SourceWindow::slots;
  for (int l = 0; l < nodes_per_window; ++l) {
    const bool inside = source[l] >= plane && source[l] < plane + capacity;
    if (!inside) w.bounced |= 1u << l;
    if (inside && source[l] < first) first = source[l];
  }
  for (int l = 0; l < nodes_per_window; ++l) {
    if (w.bounced >> l & 1u) continue;
    const int slot = source[l] - first;
    if (slot >= SourceWindow::slots) return {};
    w.from |= static_cast<std::uint32_t>(slot) << 4 * l;
    w.to[slot / 8] |= static_cast<std::uint32_t>(l) << 3 * (slot % 8) | 1u << (SourceWindow::owned_from + slot % 8);
  }
  w.first = first;
  return w;
}

/// Registers of eight numbers.
template <class T>
struct Eight;

#ifdef VUG_EIGHT_LANES
template <>
struct Eight<double> {
  using Register = __m512d;
  static Register load(const double* p) { return _mm512_loadu_pd(p); }
  static void store(double* p, Register v) { _mm512_storeu_pd(p, v); }
  static void store(double* p, std::uint32_t lanes, Register v) {
    _mm512_mask_storeu_pd(p, static_cast<__mmask8>(lanes), v);
  }
  /// Lane l: `b` where bit l of `lanes` is set, else `a`.
  static Register blend(std::uint32_t lanes, Register a, Register b) {
    return _mm512_mask_blend_pd(static_cast<__mmask8>(lanes), a, b);
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
    return _mm512_maskz_srlv_epi64(all, _mm512_set1_epi64(order), lane);
  }
};

template <>
struct Eight<float> {
  using Register = __m256;
  static Register load(const float* p) { return _mm256_loadu_ps(p); }
  static void store(float* p, Register v) { _mm256_storeu_ps(p, v); }
  static void store(float* p, std::uint32_t lanes, Register v) {
    _mm256_mask_storeu_ps(p, static_cast<__mmask8>(lanes), v);
  }
  static Register blend(std::uint32_t lanes, Register a, Register b) {
    return _mm256_mask_blend_ps(static_cast<__mmask8>(lanes), a, b);
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

/// Populations of eight consecutive nodes over a velocity set, and how they are fetched and put back.
template <class T, class Set>
struct EightNodes {
  const SourceWindow* windows;  ///< (eight nodes, direction - 1)
  const int* source;            ///< FluidNodes::source, where a window does not do
  int capacity;

  /// What arrives at nodes i .. i + 7, i a multiple of eight.
  void pull(const T* f, int i, T (&g)[Set::Q][nodes_per_window]) const {
    using E = Eight<T>;
    const SourceWindow* const window = windows + i;
    E::store(g[0], E::load(f + i));
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const SourceWindow& w = window[q - 1];
      if (w.first < 0) [[unlikely]] {
        for (int l = 0; l < nodes_per_window; ++l) g[q][l] = f[source[q * capacity + i + l]];
        continue;
      }
      const auto pulled = E::pick(w.from, E::load(f + w.first), E::load(f + w.first + nodes_per_window));
      E::store(g[q], E::blend(w.bounced, pulled, E::load(f + Set::opposite(q) * capacity + i)));
    }
  }

  /// `field` (fluid) at the nodes that the directions of i .. i + 7 come from, into `value` from `at` on; at a wall or
  /// a side that of the node itself.
  template <int some>
  void upstream(const T* field, int i, T (&value)[Set::Q][some], int at) const {
    using E = Eight<T>;
    const auto own = E::load(field + i);
    E::store(value[0] + at, own);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const SourceWindow& w = windows[i + q - 1];
      const int plane = q * capacity;
      if (w.first < 0) [[unlikely]] {
        for (int l = 0; l < nodes_per_window; ++l) {
          const int from = source[plane + i + l] - plane;
          value[q][at + l] = field[from >= 0 && from < capacity ? from : i + l];
        }
        continue;
      }
      const T* const first = field + (w.first - plane);
      const auto there = E::pick(w.from, E::load(first), E::load(first + nodes_per_window));
      E::store(value[q] + at, E::blend(w.bounced, there, own));
    }
  }

  /// Leaves what goes out against direction q where what came in along q was.
  void push(T* f, int i, const T (&g)[Set::Q][nodes_per_window]) const {
    using E = Eight<T>;
    const SourceWindow* const window = windows + i;
    E::store(f + i, E::load(g[0]));
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const SourceWindow& w = window[q - 1];
      const int opposite = Set::opposite(q);
      if (w.first < 0) [[unlikely]] {
        for (int l = 0; l < nodes_per_window; ++l) f[source[q * capacity + i + l]] = g[opposite][l];
        continue;
      }
      const auto out = E::load(g[opposite]);
      const std::uint32_t near = w.to[0] >> SourceWindow::owned_from, far = w.to[1] >> SourceWindow::owned_from;
      E::store(f + w.first, near, E::pick(w.to[0], out));
      if (far) E::store(f + w.first + nodes_per_window, far, E::pick(w.to[1], out));
      if (w.bounced) E::store(f + opposite * capacity + i, w.bounced, out);
    }
  }
};

}  // namespace vug
