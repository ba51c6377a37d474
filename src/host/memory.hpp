#pragma once
// How much is held in Views, counted by Kokkos itself on any back end, and in pages of which size.

namespace vug {

/// Starts counting the allocations of Views, and asks for large pages for large ones on a host with Linux; called once,
/// before the first.
void watch_allocations();

/// Bytes now allocated in Views since watch_allocations.
double allocated_bytes();

}  // namespace vug
