#pragma once
// Pages of a host's memory. What nobody writes takes no room: how a rank among others has fields of all nodes and holds
// its own. Large fields lie in large pages, which a processor finds faster.
#include "kernels/base/base.hpp"

#include <cstddef>
#include <string>

namespace vug {

/// Zeros `bytes` at `data`, memory of a View on the host. Whole pages go back to the system, which gives zeroed ones
/// when they are written next; where it cannot all is written.
void give_back_pages(void* data, std::size_t bytes);

/// From now on pages there are small ones, of which a few numbers take no more than they must.
void keep_pages_small(void* data, std::size_t bytes);

/// From now on pages there are large ones (2 MiB) where the system grants it, none of the small ones that an earlier
/// use of this memory has left; what was in them is lost.
void take_large_pages(void* data, std::size_t bytes);

/// A View (item) of zeros; `in_parts`: those of its items that are never written take no memory on a host.
template <class ViewType>
ViewType zeros(const Exec& exec, const std::string& label, std::size_t items, bool in_parts) {
  if (!runs_on_host || !in_parts) return ViewType(Kokkos::view_alloc(exec, label), items);
  const ViewType view(Kokkos::view_alloc(Kokkos::WithoutInitializing, label), items);
  give_back_pages(view.data(), view.span() * sizeof(typename ViewType::value_type));
  return view;
}

}  // namespace vug
