#pragma once
// Two bodies in one launch, which for short lists takes longer than the work.
#include "kernels/launch.hpp"

namespace vug {

namespace detail {

/// A block of the first body, then the same block of the second.
template <class First, class Second>
struct BlocksInTurn {
  First first;
  Second second;
  int n, size;

  template <class Body>
  KOKKOS_FORCEINLINE_FUNCTION static void run(const Body& body, int begin, int end) {
    const LocalBody<Body> copy(body);
    const Body& local = copy.body;
    VUG_VECTORISE
    for (int i = begin; i < end; ++i) local(i);
  }
  KOKKOS_FUNCTION void operator()(int block) const {
    const int begin = block * size, end = begin + size < n ? begin + size : n;
    run(first, begin, end);
    run(second, begin, end);
  }
};

template <class First, class Second>
struct NodesInTurn {
  First first;
  Second second;
  KOKKOS_FUNCTION void operator()(int i) const {
    first(i);
    second(i);
  }
};

}  // namespace detail

/// Runs first(i), then second(i), for i in [0, n). Of each, iterations must be independent; second(i) may read what
/// first(i) wrote, but not what other iterations did. The bits are those of two calls of for_each_node. Nothing is
/// fenced.
template <class First, class Second>
void for_each_node_in_turn(const Exec& exec, const std::string& label, int n, const First& first,
                           const Second& second) {
  if (n <= 0) return;
  if constexpr (runs_on_host) {
    constexpr int shortest = 32, shares = 4;  // as for_each_node, for the same reasons
    const int share = ((n + shares - 1) / shares + shortest - 1) / shortest * shortest;
    const int size = share < nodes_per_block ? share : nodes_per_block;
    const detail::BlocksInTurn<First, Second> blocks{first, second, n, size};
    if (n <= shortest)
      blocks(0);
    else
      Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, (n + size - 1) / size), blocks);
  } else {
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, n),
                         detail::NodesInTurn<First, Second>{first, second});
  }
}

}  // namespace vug
