#pragma once
// Two bodies in one launch, which for short lists takes longer than the work; over a whole list or over those groups of
// it that have something to do.
#include "kernels/launch.hpp"

#include <cstdint>

namespace vug {

/// A list in groups of `size` neighbours, each of which may be left out.
struct Groups {
  int count = 0;  ///< items of the list
  int size = 1;
  Kokkos::View<std::uint8_t*> runs;  ///< (group) 0: nothing to do
};

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

/// The groups of a block.
template <class First, class Second>
struct GroupLoops {
  First first;
  Second second;
  Groups groups;
  KOKKOS_FUNCTION void operator()(int begin, int end) const {
    const First one = first;
    const Second two = second;
    for (int i = begin; i < end; i += groups.size) {
      if (groups.runs(i / groups.size) == 0) continue;
      const int last = i + groups.size < end ? i + groups.size : end;
      VUG_VECTORISE
      for (int k = i; k < last; ++k) one(k);
      VUG_VECTORISE
      for (int k = i; k < last; ++k) two(k);
    }
  }
};

template <class First, class Second>
struct NodesOfGroups {
  First first;
  Second second;
  Groups groups;
  KOKKOS_FUNCTION void operator()(int i) const {
    if (groups.runs(i / groups.size) == 0) return;
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

/// The same over the groups that run. Threads take blocks as they come, since those groups may lie together.
template <class First, class Second>
void for_each_group_in_turn(const Exec& exec, const std::string& label, const Groups& groups, const First& first,
                            const Second& second) {
  const int n = groups.count;
  if (n <= 0) return;
  if constexpr (runs_on_host) {
    using Loops = detail::GroupLoops<First, Second>;
    const int block = (block_of_list(n) + groups.size - 1) / groups.size * groups.size;
    const detail::Block<Loops> blocks{{first, second, groups}, n, block};
    using Policy = Kokkos::RangePolicy<Exec, Kokkos::Schedule<Kokkos::Dynamic>>;
    Kokkos::parallel_for(label, Policy(exec, 0, (n + block - 1) / block), blocks);
  } else {
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, n),
                         detail::NodesOfGroups<First, Second>{first, second, groups});
  }
}

}  // namespace vug
