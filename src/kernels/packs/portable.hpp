#pragma once
// Packs for every host: the compiler's vectors in registers of `bytes` bytes, as many as eight numbers need. What
// certain processors do faster is in files of their own (avx2.hpp, avx512.hpp) and gives the same bits.
#include "base/base.hpp"

#include <cstdint>
#include <type_traits>
#include <utility>

namespace vug {

inline constexpr int pack_size = 8;

/// A pack that does not fit into one register, as two halves: V is a register, or again such halves.
template <class T, class V>
struct Halves {
  using Half = V;
  V low, high;

  KOKKOS_FORCEINLINE_FUNCTION T operator[](int lane) const {
    constexpr int half = sizeof(V) / sizeof(T);
    return lane < half ? low[lane] : high[lane - half];
  }
  KOKKOS_FORCEINLINE_FUNCTION Halves operator-() const { return {-low, -high}; }

#define VUG_LANEWISE(op)                                                                    \
  KOKKOS_FORCEINLINE_FUNCTION friend Halves operator op(const Halves& a, const Halves& b) { \
    return {a.low op b.low, a.high op b.high};                                              \
  }                                                                                         \
  KOKKOS_FORCEINLINE_FUNCTION friend Halves operator op(T a, const Halves& b) {             \
    return {a op b.low, a op b.high};                                                       \
  }                                                                                         \
  KOKKOS_FORCEINLINE_FUNCTION friend Halves operator op(const Halves& a, T b) {             \
    return {a.low op b, a.high op b};                                                       \
  }                                                                                         \
  template <class Other>                                                                    \
  KOKKOS_FORCEINLINE_FUNCTION Halves& operator op##=(const Other& b) {                      \
    return *this = *this op b;                                                              \
  }
  VUG_LANEWISE(+)
  VUG_LANEWISE(-)
  VUG_LANEWISE(*)
  VUG_LANEWISE(/)
#undef VUG_LANEWISE
};

/// Eight numbers and the operations on them other than arithmetic. Bit l of `lanes` stands for number l.
template <class T, int bytes>
class PortablePack {
  template <int count, bool fits = count * sizeof(T) <= bytes>
  struct Type {
    typedef T type __attribute__((vector_size(count * sizeof(T))));
  };
  template <int count>
  struct Type<count, false> {
    using type = Halves<T, typename Type<count / 2>::type>;
  };

 public:
  using Pack = typename Type<pack_size>::type;
  /// Whether loads, a permutation and masked stores of runs of slots take less time than loads and stores one by one.
  static constexpr bool permutes = false;

  KOKKOS_FORCEINLINE_FUNCTION static Pack load(const T* p) { return load_all<Pack>(p); }
  /// Reads the lanes in `lanes`; the others are zero.
  static Pack load(const T* p, std::uint32_t lanes) {
    return each([&](int l) { return lanes >> l & 1 ? p[l] : T(0); });
  }
  KOKKOS_FORCEINLINE_FUNCTION static void store(T* p, const Pack& v) { store_all(p, v); }
  /// Writes the lanes in `lanes`.
  static void store(T* p, std::uint32_t lanes, const Pack& v) {
    alignas(64) T lane[pack_size];
    store(lane, v);
    for (int l = 0; l < pack_size; ++l)
      if (lanes >> l & 1) p[l] = lane[l];
  }
  /// Lane l: p[at[l]].
  KOKKOS_FORCEINLINE_FUNCTION static Pack gather(const T* p, const int* at) { return gather_all<Pack>(p, at); }
  /// p[at[l]] = lane l.
  KOKKOS_FORCEINLINE_FUNCTION static void scatter(T* p, const int* at, const Pack& v) { scatter_all(p, at, v); }

  /// Adds each lane to its sum.
  KOKKOS_FORCEINLINE_FUNCTION static void add_to(double (&sums)[pack_size], const Pack& v) {
    alignas(64) T lane[pack_size];
    store(lane, v);
    for (int l = 0; l < pack_size; ++l) sums[l] += static_cast<double>(lane[l]);
  }
  /// Whether some lane of `a` is above that of `b`.
  KOKKOS_FORCEINLINE_FUNCTION static bool any_above(const Pack& a, const Pack& b) { return is_any_above(a, b); }
  /// Lane l: that of `b` if it is in `lanes`, else that of `a`.
  KOKKOS_FORCEINLINE_FUNCTION static Pack blend(std::uint32_t lanes, const Pack& a, const Pack& b) {
    return blend_all(lanes, a, b);
  }
  /// The first numbers at p, in order, in the lanes in `lanes`; the others are zero. Reads no more numbers than that.
  static Pack spread(std::uint32_t lanes, const T* p) {
    return each([&](int l) { return lanes >> l & 1 ? *p++ : T(0); });
  }
  /// As many of the first lanes as there are lanes in `lanes`.
  KOKKOS_FORCEINLINE_FUNCTION static std::uint32_t first(std::uint32_t lanes) {
    return (1U << Kokkos::Experimental::popcount_builtin(lanes)) - 1;
  }
  /// Lane l: number (order >> 4 l) % 16 of the sixteen in `a` and `b`.
  static Pack pick(std::uint32_t order, const Pack& a, const Pack& b) {
    alignas(64) T lane[2 * pack_size];
    store(lane, a);
    store(lane + pack_size, b);
    return each([&](int l) { return lane[order >> 4 * l & 15]; });
  }
  /// Lane l: number (order >> 3 l) % 8 of `a`.
  static Pack pick(std::uint32_t order, const Pack& a) {
    alignas(64) T lane[pack_size];
    store(lane, a);
    return each([&](int l) { return lane[order >> 3 * l & 7]; });
  }

 private:
  template <class V>
  static constexpr bool is_register = !requires {
    typename V::Half;
  };
  template <class V>
  static constexpr int lanes_of = sizeof(V) / sizeof(T);
  template <class V, class Word>
  struct WordsOf {
    typedef Word type __attribute__((vector_size(sizeof(V))));
  };
  template <class V>
  using Numbers = std::make_integer_sequence<int, lanes_of<V>>;

  template <class Lane>
  KOKKOS_FORCEINLINE_FUNCTION static Pack each(const Lane& value) {
    alignas(64) T lane[pack_size];
    for (int l = 0; l < pack_size; ++l) lane[l] = value(l);
    return load(lane);
  }

  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V load_all(const T* p) {
    if constexpr (is_register<V>) {
      V v;
      __builtin_memcpy(&v, p, sizeof v);
      return v;
    } else {
      using Half = typename V::Half;
      return {load_all<Half>(p), load_all<Half>(p + lanes_of<Half>)};
    }
  }
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static void store_all(T* p, const V& v) {
    if constexpr (is_register<V>) {
      __builtin_memcpy(p, &v, sizeof v);
    } else {
      store_all(p, v.low);
      store_all(p + lanes_of<typename V::Half>, v.high);
    }
  }
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V gather_all(const T* p, const int* at) {
    if constexpr (is_register<V>) {
      return [&]<int... l>(std::integer_sequence<int, l...>) __attribute__((always_inline)) {
        return V{p[at[l]]...};
      }
      (Numbers<V>{});
    } else {
      using Half = typename V::Half;
      return {gather_all<Half>(p, at), gather_all<Half>(p, at + lanes_of<Half>)};
    }
  }
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static void scatter_all(T* p, const int* at, const V& v) {
    if constexpr (is_register<V>) {
      [&]<int... l>(std::integer_sequence<int, l...>) __attribute__((always_inline)) {
        ((p[at[l]] = v[l]), ...);
      }
      (Numbers<V>{});
    } else {
      scatter_all(p, at, v.low);
      scatter_all(p, at + lanes_of<typename V::Half>, v.high);
    }
  }
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V blend_all(std::uint32_t lanes, const V& a, const V& b) {
    if constexpr (is_register<V>) {
      return [&]<int... l>(std::integer_sequence<int, l...>) __attribute__((always_inline)) {
        using Word = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
        using Words = typename WordsOf<V, Word>::type;
        const Words bit{(Word{1} << l)...};
        return ((Words{} + static_cast<Word>(lanes)) & bit) != 0 ? b : a;
      }
      (Numbers<V>{});
    } else {
      return {blend_all(lanes, a.low, b.low), blend_all(lanes >> lanes_of<typename V::Half>, a.high, b.high)};
    }
  }
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static bool is_any_above(const V& a, const V& b) {
    if constexpr (is_register<V>) {
      const auto above = (typename WordsOf<V, long long>::type)(a > b);
      long long any = 0;
      for (int w = 0; w < int{sizeof(V) / sizeof(long long)}; ++w) any |= above[w];
      return any != 0;
    } else {
      return int{is_any_above(a.low, b.low)} | int{is_any_above(a.high, b.high)};  // neither is skipped
    }
  }
};

/// The pack of numbers T on this host.
template <class T>
struct PackOf : PortablePack<T, 16> {};

}  // namespace vug
