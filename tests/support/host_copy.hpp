#pragma once
// Values of a device view on the host.
#include "kernels/base/base.hpp"

namespace vug::test {

/// The values of a view as they are now: a copy also where the view lies on the host, so that "before" stays before.
template <class ViewType>
auto host_copy(const ViewType& view) {
  const auto copy = Kokkos::create_mirror(Kokkos::HostSpace{}, view);
  Kokkos::deep_copy(copy, view);
  return copy;
}

}  // namespace vug::test
