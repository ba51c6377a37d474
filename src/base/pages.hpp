#pragma once
// Pages of host memory. Pages that are never written take no memory: a rank can have fields over all nodes of which
// only its own nodes take room. Large fields are in large pages, whose addresses a processor translates faster.
#include "base/base.hpp"

#include <cstddef>
#include <string>

namespace vug {

/// Sets `bytes` bytes at `data`, memory of a View on the host, to zero. Whole pages are returned to the system, which
/// supplies zeroed ones when they are next written; where that is not possible, zeros are written.
void give_back_pages(void* data, std::size_t bytes);

/// Makes new pages there small, so that a few numbers take no more memory than necessary.
void keep_pages_small(void* data, std::size_t bytes);

/// Makes pages there large (2 MiB) where the system allows it, and drops small ones that an earlier use of this memory
/// has left. The content is lost.
void take_large_pages(void* data, std::size_t bytes);

/// A View (item) of zeros. With `in_parts`, items that are never written take no memory on a host.
template <class ViewType>
ViewType zeros(const Exec& exec, const std::string& label, std::size_t items, bool in_parts) {
  if (!runs_on_host || !in_parts) return ViewType(Kokkos::view_alloc(exec, label), items);
  const ViewType view(Kokkos::view_alloc(Kokkos::WithoutInitializing, label), items);
  give_back_pages(view.data(), view.span() * sizeof(typename ViewType::value_type));
  return view;
}

}  // namespace vug
