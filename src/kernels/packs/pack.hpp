#pragma once
// Packs of eight numbers, on hosts: a kernel's law takes a pack as it takes a number, and memory is read and written by
// eights. The same code serves every processor; those with a file of their own below are faster.
#include "base/base.hpp"

// Not on a GPU, where each thread has one number.
#if !defined(__CUDACC__) && !defined(__HIPCC__)
#include "kernels/packs/avx2.hpp"
#include "kernels/packs/avx512.hpp"
#include "kernels/packs/portable.hpp"

namespace vug {
inline constexpr bool packs_permute = PackOf<double>::permutes;
}  // namespace vug
#else
namespace vug {
inline constexpr int pack_size = 8;
inline constexpr bool packs_permute = false;
template <class T>
struct PackOf;
}  // namespace vug
#endif

namespace vug {

/// Eight numbers.
template <class T>
using Pack = typename PackOf<T>::Pack;

/// The number at `from` or, where V is a pack, the eight numbers from there on.
template <class V, class T>
KOKKOS_FORCEINLINE_FUNCTION V fetch(const T* from) {
  if constexpr (sizeof(V) == sizeof(T))
    return *from;
  else
    return PackOf<T>::load(from);
}
/// Writes a number or a pack to `to`.
template <class V, class T>
KOKKOS_FORCEINLINE_FUNCTION void put(T* to, const V& value) {
  if constexpr (sizeof(V) == sizeof(T))
    *to = value;
  else
    PackOf<T>::store(to, value);
}

}  // namespace vug
