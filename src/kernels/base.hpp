#pragma once
// The few types that every layer shares: where kernels run and how fields are stored.
#include <Kokkos_Core.hpp>

namespace vug {

using Exec = Kokkos::DefaultExecutionSpace;

/// True where kernels run on the host, so that loops over nodes must vectorise.
inline constexpr bool runs_on_host =
    Kokkos::SpaceAccessibility<Kokkos::HostSpace, typename Exec::memory_space>::accessible;

template <class T>
using ScalarField = Kokkos::View<T*>;  ///< (item)
template <class T>
using VectorField = Kokkos::View<T* [2], Kokkos::LayoutLeft>;  ///< (item, axis), each component contiguous
using IndexList = Kokkos::View<int*>;                          ///< (item)

}  // namespace vug
