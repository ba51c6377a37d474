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

/// The population at rest of a node, or of a pack of nodes, where the others change and the sum of all is given. In
/// double precision it gets what the others leave of an amount. In single precision it loses what they gain and gains
/// what is `added` to all of them, which is kept apart until the end. Their changes are summed by pairs of opposite
/// directions: what flows through a node leaves one of them and enters the other, and cancels exactly, however large it
/// is.
template <class T, class Set, class V>
class RestPopulation {
 public:
  KOKKOS_FORCEINLINE_FUNCTION RestPopulation(const V& amount, const V& added) : left_(amount), added_(added) {}

  /// Population q becomes `after` and so takes `taken` of the amount.
  KOKKOS_FORCEINLINE_FUNCTION void change(int q, const V& before, const V& after, const V& taken) {
    if constexpr (Rounding<T>::to_nearest)
      left_ -= taken;
    else
      change_[q] = after - before;
  }

  /// What was `rest`, where the amount is the sum of all populations.
  KOKKOS_FORCEINLINE_FUNCTION V of_sum(const V& rest, const Rounding<T>& rounding, int node) const {
    if constexpr (Rounding<T>::to_nearest)
      return left_;
    else
      return changed(rest, rounding, node);
  }
  /// The same where the amount is what is added to all of them.
  KOKKOS_FORCEINLINE_FUNCTION V of_gain(const V& rest, const Rounding<T>& rounding, int node) const {
    if constexpr (Rounding<T>::to_nearest)
      return rest + left_;
    else
      return changed(rest, rounding, node);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION V changed(const V& rest, const Rounding<T>& rounding, int node) const {
    V all{};
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q)
      if (q < Set::opposite(q)) all += change_[q] + change_[Set::opposite(q)];
    return rounding.sum(rest, -all, added_, node);
  }

  V left_, added_, change_[Set::Q];
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
