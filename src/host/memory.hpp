#pragma once
// Memory held in Views, counted by Kokkos itself on any back end, and the size of its pages.

namespace vug {

/// Starts counting the allocations of Views and, on a host with Linux, requesting large pages for large ones. Called
/// once, before the first allocation.
void watch_allocations();

/// Bytes now allocated in Views since watch_allocations.
double allocated_bytes();

}  // namespace vug
