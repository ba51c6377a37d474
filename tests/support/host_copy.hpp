#pragma once
// Values of a device view on the host: read, changed.
#include "base/base.hpp"

namespace vug::test {

/// The values of a view as they are now: a copy also where the view lies on the host, so that "before" stays before.
template <class ViewType>
auto host_copy(const ViewType& view) {
  const auto copy = Kokkos::create_mirror(Kokkos::HostSpace{}, view);
  Kokkos::deep_copy(copy, view);
  return copy;
}

/// Has `change` write to the values of a view on the host, then puts them where the view lies.
template <class ViewType, class Change>
void edit(const ViewType& view, const Change& change) {
  const auto host = host_copy(view);
  change(host);
  Kokkos::deep_copy(view, host);
}

/// view(i) = value, from the host.
template <class ViewType>
void set_entry(const ViewType& view, int i, typename ViewType::non_const_value_type value) {
  edit(view, [&](const auto& host) { host(i) = value; });
}

}  // namespace vug::test
