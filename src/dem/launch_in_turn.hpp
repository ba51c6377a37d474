#pragma once
// Two bodies in one launch, because a launch takes longer than the work of short lists. They run one after the other
// over a list, or over those groups of it that have something to do, or side by side over two lists.
#include "dem/recording.hpp"
#include "kernels/launch/launch.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace vug {

/// A list in groups of `size` neighbours, each of which may be left out.
struct Groups {
  int count = 0;  ///< items of the list
  int size = 1;
  Kokkos::View<std::uint8_t*> runs;  ///< (group) 0: nothing to do
  Kokkos::View<std::uint8_t*> ours;  ///< (group) 0: another process computes it; empty: all are ours

  KOKKOS_FORCEINLINE_FUNCTION int number() const { return (count + size - 1) / size; }
  KOKKOS_FORCEINLINE_FUNCTION int group_of(int item) const { return item / size; }
  KOKKOS_FORCEINLINE_FUNCTION bool is_ours(int group) const { return ours.data() == nullptr || ours(group) != 0; }
  KOKKOS_FORCEINLINE_FUNCTION bool runs_here(int group) const { return runs(group) != 0 && is_ours(group); }
  /// Number of groups that run here.
  KOKKOS_FORCEINLINE_FUNCTION int running() const {
    int sum = 0;
    for (int group = 0; group < number(); ++group) sum += runs_here(group);
    return sum;
  }
};

/// Begin of one of equal shares of `count` items; count times share may exceed the range of an int.
KOKKOS_FORCEINLINE_FUNCTION int begin_of_share(int count, int share, int shares) {
  return static_cast<int>(std::int64_t{count} * share / shares);
}

/// Work for a launch: blocks of a list on a host, its items on a GPU. Bodies are moved into it, because a copy
/// increments the reference counts of all Views of the body, which took a sixth of a step on a small lattice.
template <class Body>
struct Work {
  Body body;
  int count = 0;
};

namespace detail {

/// Runs a block of the first body, then the same block of the second.
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

/// Runs one of equal shares of the groups that run, in their order. A thread has the same groups in every launch while
/// the same groups run, so that they stay in its caches. Neighbours are one loop, because a loop over a group of eight
/// is shorter than what a compiler does at once.
template <class First, class Second>
struct GroupLoops {
  First first;
  Second second;
  Groups groups;
  int shares;
  KOKKOS_FUNCTION void operator()(int share) const {
    const First one = first;
    const Second two = second;
    const std::int64_t running = groups.running();
    const auto begin = running * share / shares, end = running * (share + 1) / shares;
    const int most = nodes_per_block / groups.size;
    std::int64_t seen = 0;
    for (int g = 0; seen < end; ++g) {
      if (!groups.runs_here(g) || seen++ < begin) continue;
      const int from = g * groups.size, last = g + most;
      for (; seen < end && g + 1 < last && groups.runs_here(g + 1); ++g) ++seen;
      const int after = (g + 1) * groups.size, to = after < groups.count ? after : groups.count;
      VUG_VECTORISE
      for (int k = from; k < to; ++k) one(k);
      VUG_VECTORISE
      for (int k = from; k < to; ++k) two(k);
    }
  }
};

template <class First, class Second>
struct NodesOfGroups {
  First first;
  Second second;
  Groups groups;
  KOKKOS_FUNCTION void operator()(int i) const {
    if (!groups.runs_here(groups.group_of(i))) return;
    first(i);
    second(i);
  }
};

struct Nothing {
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int) const {}
};

/// On a host runs a share of the blocks of each list, so that every thread has some of both; on a GPU all items of one
/// list, then of the other.
template <class One, class Other>
struct SideBySide {
  One one;
  Other other;
  int ones, others, shares;
  KOKKOS_FUNCTION void operator()(int i) const {
    if constexpr (runs_on_host) {
      for (int b = begin_of_share(ones, i, shares); b < begin_of_share(ones, i + 1, shares); ++b) one(b);
      for (int b = begin_of_share(others, i, shares); b < begin_of_share(others, i + 1, shares); ++b) other(b);
    } else {
      if (i < ones)
        one(i);
      else
        other(i - ones);
    }
  }
};

inline int blocks_of(int n, int size) {
  return n > 0 ? (n + size - 1) / size : 0;
}

}  // namespace detail

/// Work that calls body(i) for i in [0, n); the calls must be independent.
template <class Body>
auto each(int n, Body body) {
  if constexpr (runs_on_host) {
    const int size = block_of_list(n);
    return Work<detail::Block<detail::NodeLoop<Body>>>{{{std::move(body)}, n, size}, detail::blocks_of(n, size)};
  } else {
    return Work<Body>{std::move(body), n};
  }
}

/// Work that calls first(i), then second(i), for i in [0, n). Iterations of each body must be independent; second(i)
/// may read what first(i) wrote, but not what other iterations wrote. Results are the same to the bit as those of two
/// calls of for_each_node.
template <class First, class Second>
auto in_turn(int n, First first, Second second) {
  if constexpr (runs_on_host) {
    using Loops = detail::LoopsInTurn<First, Second>;
    const int size = block_of_list(n);
    return Work<detail::Block<Loops>>{{{{std::move(first)}, {std::move(second)}}, n, size}, detail::blocks_of(n, size)};
  } else {
    return Work<detail::NodesInTurn<First, Second>>{{std::move(first), std::move(second)}, n};
  }
}

/// The same over the groups that run; on a host every thread takes a share of these.
template <class First, class Second>
auto in_turn([[maybe_unused]] const Exec& exec, const Groups& groups, First first, Second second) {
  const int n = groups.count;
  if constexpr (runs_on_host) {
    const int shares = std::min(detail::blocks_of(n, block_of_list(n)), exec.concurrency());
    return Work<detail::GroupLoops<First, Second>>{{std::move(first), std::move(second), groups, shares}, shares};
  } else {
    return Work<detail::NodesOfGroups<First, Second>>{{std::move(first), std::move(second), groups}, n};
  }
}

/// Work that calls body(i) for the items of the groups that run.
template <class Body>
auto each(const Exec& exec, const Groups& groups, Body body) {
  return in_turn(exec, groups, std::move(body), detail::Nothing{});
}

/// Work on two lists at once; neither may read what the other writes.
template <class One, class Other>
auto side_by_side(Work<One> one, Work<Other> other) {
  const int ones = one.count, others = other.count, most = ones > others ? ones : others;
  return Work<detail::SideBySide<One, Other>>{{std::move(one.body), std::move(other.body), ones, others, most},
                                              runs_on_host ? most : ones + others};
}

/// Runs the work in one launch, or records it. On a host, work of one block runs without waking other threads. There is
/// no fence.
template <class Body>
void launch(const Queue& queue, const std::string& label, const Work<Body>& work) {
  if (work.count <= 0) return;
  const Kokkos::RangePolicy<Exec> policy(queue.exec, 0, work.count);
  if (queue.recording) return queue.recording->add(label, policy, work.body);
  if (runs_on_host && work.count == 1)
    Kokkos::parallel_for(label, Kokkos::RangePolicy<ShortExec>(0, 1), work.body);
  else
    Kokkos::parallel_for(label, policy, work.body);
}

}  // namespace vug
