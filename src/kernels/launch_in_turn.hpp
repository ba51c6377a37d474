#pragma once
// Two bodies in one launch, which for short lists takes longer than the work.
#include "kernels/launch.hpp"

namespace vug {

namespace detail {

/// A block of the first body, then the same block of the second.
template <class First, class Second>
struct LoopsInTurn {
  NodeLoop<First> first;
  NodeLoop<Second> second;
  KOKKOS_FUNCTION void operator()(int begin, int end) const {
    first(begin, end);
    second(begin, end);
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
  if constexpr (runs_on_host)
    for_each_block(exec, label, n, detail::LoopsInTurn<First, Second>{{first}, {second}}, block_of_list(n));
  else
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, n),
                         detail::NodesInTurn<First, Second>{first, second});
}

}  // namespace vug
