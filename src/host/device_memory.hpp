#pragma once
// Check that the memory space in which kernels run has enough memory.
#include "host/free_memory.hpp"

#include <Kokkos_Core.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace vug {

/// Throws MemoryError unless a memory space has `bytes` in one piece for `what`. The bytes are allocated and freed,
/// because Kokkos does not say how much memory of a GPU is free.
template <class Space>
void require_room(double bytes, const std::string& what) {
  try {
    Kokkos::kokkos_free<Space>(Kokkos::kokkos_malloc<Space>("vug::room", static_cast<std::size_t>(bytes)));
  } catch (const std::runtime_error&) {  // Kokkos has no type of its own for this
    refuse_memory(bytes, what, std::string("the memory of ") + Space::execution_space::name() + " has less free");
  }
}

}  // namespace vug
