#pragma once
// Copies from a list on the host to a View, and back.
#include <Kokkos_Core.hpp>

#include <string>
#include <vector>

namespace vug {

/// A new View (entry) on the device with the entries of `values`.
template <class ViewType>
ViewType to_device(const std::string& label, const std::vector<typename ViewType::non_const_value_type>& values) {
  using Host = Kokkos::View<const typename ViewType::non_const_value_type*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged>;
  ViewType view(label, values.size());
  Kokkos::deep_copy(view, Host(values.data(), values.size()));
  return view;
}

/// The content of a View for reading on the host: the View itself where it is in host memory, else a copy made now.
template <class ViewType>
auto on_host(const ViewType& view) {
  return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view);
}

}  // namespace vug
