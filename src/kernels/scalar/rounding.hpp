#pragma once
// Rounding that is right in the mean over many steps, for scalars in single precision.
//
// What a step adds to a number may be less than half the distance to the next float. Rounded to the nearest, it would
// be lost, and lost again in the next step: slow changes would stand still before they are complete, and what is lost
// would be missing in the balance (up to 1e-8 of the amount per step, 1 % in a million steps). Here a sum is rounded up
// or down at random, with the odds at which the mean is the exact sum. Numbers that are exact stay as they are. In
// double precision the same loss is 1e-17 per step, and sums are ordinary sums.
#include "base/splitmix64.hpp"
#include "base/unroll.hpp"
#include "base/velocity_set.hpp"
#include "kernels/packs/pack.hpp"

#include <type_traits>

namespace vug {

/// How the sums of one step are rounded; by default to the nearest number.
///
/// A sum is shifted by a part of its last place before it is rounded. The shifts of a step begin at a random number and
/// go on, item by item, by the golden ratio: those of neighbours are as different as can be, and every one of them is
/// independent of what earlier steps have rounded. (With a sequence over the steps in place of the random numbers what
/// is rounded may get into step with it; a tenth of a small flux was lost so.) They depend on step and item alone, so
/// that the bits are the same for any threads and processes, and after a restart.
template <class T>
struct Rounding {
  static constexpr bool to_nearest = std::is_same_v<T, double>;

  std::uint32_t first = 1U << 31, next = 0;  ///< 32 bits after the point, of which 20 count

  /// Shift in (-1/2, 1/2) of the last place, of an item or, where V is a pack, of consecutive items from there on.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION V shift(int item) const {
    if constexpr (std::is_same_v<V, T>) {
      const std::uint32_t bits = (first + next * static_cast<std::uint32_t>(item)) >> 12;
      return static_cast<T>(static_cast<int>(bits)) * T(0x1p-20) + T(0x1p-21 - 0.5);
    } else {
      alignas(64) T lane[pack_size];
      for (int l = 0; l < pack_size; ++l) lane[l] = shift<T>(item + l);
      return fetch<V>(lane);
    }
  }

  /// a + b, for an item or a pack of them.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION V sum(const V& a, const V& b, int item) const {
    const V nearest = a + b;
    if constexpr (to_nearest)
      return nearest;
    else
      return moved(nearest, lacking(a, b, nearest), item);
  }
  /// a + b + more, rounded once. Added to b first, `more` would be rounded to the nearest place of b, which may be far
  /// larger and of the same size in every step.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION V sum(const V& a, const V& b, const V& more, int item) const {
    const V both = a + b, nearest = both + more;
    if constexpr (to_nearest)
      return nearest;
    else
      return moved(nearest, lacking(a, b, both) + lacking(both, more, nearest), item);
  }

  /// What `nearest`, the rounded a + b, lacks: exactly if |a| >= |b| (Dekker's two-sum). Zero in double precision.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V lacking(const V& a, const V& b, const V& nearest) {
    if constexpr (to_nearest)
      return V{};
    else
      return b - (nearest - a);
  }

 private:
  /// `nearest` or a number beside it, so that the mean is nearest + lost: adding and subtracting a number with the last
  /// place of the sum decides.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION V moved(const V& nearest, const V& lost, int item) const {
    constexpr T over_half = T(0x1.004p-24), large = T(0x1.8p23);  // over half of the last place, for any digits
    const V last_place = (nearest + over_half * nearest) - nearest;
    const V coarse = large * last_place;
    return nearest + ((lost + shift<V>(item) * last_place + coarse) - coarse);
  }
};

/// Changes of the populations that move, in single precision. Their sum is taken by pairs of opposite directions: what
/// flows through a node leaves one of them and enters the other, and cancels exactly, however large it is.
template <class V, class Set>
struct ChangesByPairs {
  V of[Set::Q];

  KOKKOS_FORCEINLINE_FUNCTION V sum() const {
    V all{};
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q)
      if (q < Set::opposite(q)) all += of[q] + of[Set::opposite(q)];
    return all;
  }
};

/// What the population at rest gains where the others change: an amount that is `added` to all of them, less what the
/// others store of it. In single precision the amount is kept apart until the end.
template <class T, class Set, class V>
class RestGain {
 public:
  KOKKOS_FORCEINLINE_FUNCTION explicit RestGain(const V& added) : added_(added), left_(added) {}

  /// Population q becomes `after` by `change`.
  KOKKOS_FORCEINLINE_FUNCTION void give(int q, const V& before, const V& after, const V& change) {
    if constexpr (Rounding<T>::to_nearest)
      left_ -= change;
    else
      changes_.of[q] = after - before;
  }

  /// The population at rest of a node or of a pack of nodes, which was `rest`.
  KOKKOS_FORCEINLINE_FUNCTION V added_to(const V& rest, const Rounding<T>& rounding, int node) const {
    if constexpr (Rounding<T>::to_nearest)
      return rest + left_;
    else
      return rounding.sum(rest, -changes_.sum(), added_, node);
  }

 private:
  V added_, left_;
  ChangesByPairs<V, Set> changes_;
};

/// The population at rest after a collision, which conserves the sum of populations.
template <class T, class Set, class V>
class RestPopulation {
 public:
  /// `rest` is the population at rest that has arrived. `sum` is the sum of all of them and of what is `added`, which
  /// in single precision is kept apart until the end.
  KOKKOS_FORCEINLINE_FUNCTION RestPopulation(const V& rest, const V& sum, const V& added = {})
      : rest_(rest), added_(added), left_(sum) {}

  /// Population q becomes `after`.
  KOKKOS_FORCEINLINE_FUNCTION void replace(int q, const V& before, const V& after) {
    if constexpr (Rounding<T>::to_nearest)
      left_ -= after;
    else
      changes_.of[q] = after - before;
  }

  /// That of a node or of a pack of nodes.
  KOKKOS_FORCEINLINE_FUNCTION V value(const Rounding<T>& rounding, int node) const {
    if constexpr (Rounding<T>::to_nearest)
      return left_;
    else
      return rounding.sum(rest_, -changes_.sum(), added_, node);
  }

 private:
  V rest_, added_, left_;
  ChangesByPairs<V, Set> changes_;
};

/// The roundings of a step: at nodes, and where something enters or reacts.
template <class T>
struct StepRounding {
  Rounding<T> at_nodes, at_links;
};

/// Roundings of a step by its number.
template <class T>
StepRounding<T> rounding_of_step(std::int64_t step) {
  constexpr std::uint32_t golden = 0x9E377000;  // an odd multiple of the last place of 20 bits
  const std::uint64_t bits = splitmix64(static_cast<std::uint64_t>(step));
  return {{static_cast<std::uint32_t>(bits) & ~0xFFFU, golden},
          {static_cast<std::uint32_t>(bits >> 32) & ~0xFFFU, golden}};
}

}  // namespace vug
