#pragma once
// How much is held in Views: counted by Kokkos itself, on any back end.

namespace vug {

/// Starts counting the allocations of Views; called once, before the first.
void count_allocations();

/// Bytes now allocated in Views since count_allocations.
double allocated_bytes();

}  // namespace vug
