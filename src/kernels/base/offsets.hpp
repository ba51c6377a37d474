#pragma once
// Offsets of lists of different lengths that are stored one behind the other in one array.
#include "kernels/base/base.hpp"

#include <string>

namespace vug {

namespace detail {
struct AccumulateCounts {
  IndexList offset;
  KOKKOS_FUNCTION void operator()(int i, int& sum, bool last) const {
    sum += offset(i);
    if (last) offset(i) = sum;
  }
};
}  // namespace detail

/// Turns counts into offsets, in place: offset(i + 1), the length of list i, becomes the end of list i; offset(0) is
/// zero. Returns the total length, for which it waits.
inline int accumulate_counts(const Exec& exec, const std::string& label, const IndexList& offset) {
  int all = 0;
  Kokkos::parallel_scan(label, Kokkos::RangePolicy<Exec>(exec, 0, static_cast<int>(offset.extent(0))),
                        detail::AccumulateCounts{offset}, all);
  return all;
}

}  // namespace vug
