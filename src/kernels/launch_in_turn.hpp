#pragma once
// Two bodies in one launch, which for short lists takes longer than the work; over a whole list or over those groups of
// it that have something to do.
#include "kernels/launch.hpp"

#include <cstdint>

namespace vug {

/// A list in groups, each of which may be left out: group g has the items [first(g), first(g + 1)).
struct Groups {
  int count = 0;
  IndexList first;                   ///< (group + 1)
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

/// A group on a host.
template <class First, class Second>
struct GroupLoops {
  Groups groups;
  LoopsInTurn<First, Second> loops;
  KOKKOS_FUNCTION void operator()(int g) const {
    if (groups.runs(g) != 0) loops(groups.first(g), groups.first(g + 1));
  }
};

/// A group on a GPU, by a team.
template <class First, class Second>
struct GroupTeam {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  Groups groups;
  NodesInTurn<First, Second> nodes;
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int g = team.league_rank();
    if (groups.runs(g) == 0) return;
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, groups.first(g), groups.first(g + 1)), nodes);
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

/// The same over the groups that run. Threads take groups as they come, since those may lie together.
template <class First, class Second>
void for_each_group_in_turn(const Exec& exec, const std::string& label, const Groups& groups, const First& first,
                            const Second& second) {
  if (groups.count <= 0) return;
  if constexpr (runs_on_host)
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec, Kokkos::Schedule<Kokkos::Dynamic>>(exec, 0, groups.count),
                         detail::GroupLoops<First, Second>{groups, {{first}, {second}}});
  else
    Kokkos::parallel_for(label, Kokkos::TeamPolicy<Exec>(exec, groups.count, Kokkos::AUTO),
                         detail::GroupTeam<First, Second>{groups, {first, second}});
}

}  // namespace vug
