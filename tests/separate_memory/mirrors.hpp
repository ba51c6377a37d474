#pragma once
// Included before every source of a build with VUG_SEPARATE_MEMORY: mirrors are copies, as they are for a GPU, and lie
// in memory that the host may touch at any time (device_memory.cpp).
#include <Kokkos_Core.hpp>

namespace vug::test {

/// While one lives, what this thread allocates for Views is the host's.
struct AllocatesOnHost {
  AllocatesOnHost();
  ~AllocatesOnHost();
};

}  // namespace vug::test

namespace Kokkos {

template <class... Arguments>
auto create_separate_mirror(const Arguments&... arguments) {
  const vug::test::AllocatesOnHost now;
  return create_mirror(arguments...);
}

template <class Space, class ViewType>
auto create_separate_copy(const Space& space, const ViewType& view) {
  const auto copy = create_separate_mirror(space, view);
  deep_copy(copy, view);
  return copy;
}

}  // namespace Kokkos

#define create_mirror create_separate_mirror
#define create_mirror_view create_separate_mirror
#define create_mirror_view_and_copy create_separate_copy
