#pragma once
// Rounding that is right in the mean over many steps, for scalars in single precision.
//
// What a step adds to a number may be less than half the distance to the next float. Rounded to the nearest, it would
// be lost, and lost again in the next step: slow changes would stand still before they are complete, and what is lost
// would be missing in the balance (up to 1e-8 of the amount per step, 1 % in a million steps). Here a sum is rounded up
// or down at random, with the odds at which the mean is the exact sum. Numbers that are exact stay as they are. In
// double precision the same loss is 1e-17 per step, and sums are ordinary sums.
#include "base/splitmix64.hpp"
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

  /// a + b, for an item or a pack of them. `lost` is what the nearest number lacks, exactly if |a| >= |b| (Dekker's
  /// two-sum). It is made up for by a move to the next number or by none: adding and subtracting a number with the last
  /// place of the sum decides.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION V sum(const V& a, const V& b, int item) const {
    const V nearest = a + b;
    if constexpr (to_nearest) {
      return nearest;
    } else {
      constexpr T over_half = T(0x1.004p-24), large = T(0x1.8p23);  // over half of the last place, for any digits
      const V lost = b - (nearest - a);
      const V last_place = (nearest + over_half * nearest) - nearest;
      const V coarse = large * last_place;
      return nearest + ((lost + shift<V>(item) * last_place + coarse) - coarse);
    }
  }

  /// What a number gains by `change`, which has made it `after`: the difference that is stored, where that counts.
  template <class V>
  KOKKOS_FORCEINLINE_FUNCTION static V gained(const V& before, const V& after, const V& change) {
    if constexpr (to_nearest)
      return change;
    else
      return after - before;
  }
};

/// The population at rest after a collision, which conserves the sum of populations.
template <class T, class V>
class RestPopulation {
 public:
  /// `rest` is the population at rest that has arrived. `sum` is the sum of all of them and of what is `added`.
  KOKKOS_FORCEINLINE_FUNCTION RestPopulation(const V& rest, const V& sum, const V& added = {})
      : rest_(rest), left_(Rounding<T>::to_nearest ? sum : added) {}

  /// One of the other populations becomes `after`.
  KOKKOS_FORCEINLINE_FUNCTION void replace(const V& before, const V& after) {
    left_ -= Rounding<T>::to_nearest ? after : after - before;
  }

  /// That of a node or of a pack of nodes.
  KOKKOS_FORCEINLINE_FUNCTION V value(const Rounding<T>& rounding, int node) const {
    if constexpr (Rounding<T>::to_nearest)
      return left_;
    else
      return rounding.sum(rest_, left_, node);
  }

 private:
  V rest_, left_;
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
