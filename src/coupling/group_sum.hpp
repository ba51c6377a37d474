#pragma once
// Sums over groups of items (the nodes of a triangle, of a bond) in a fixed order: same bits on every run.
#include "coupling/rock_map.hpp"

#include <string>

namespace vug {

namespace detail {

template <class Sum, class Value, class Store>
struct GroupSumOnHost {
  Groups groups;
  Value value;
  Store store;
  KOKKOS_FUNCTION void operator()(int g) const {
    Sum sum{};
    for (int k = groups.offset(g); k < groups.offset(g + 1); ++k) sum += value(groups.item(k), g);
    store(g, sum);
  }
};

template <class Sum, class Value, class Store>
struct GroupSumByTeam {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  Groups groups;
  Value value;
  Store store;
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int g = team.league_rank();
    Sum sum{};
    Kokkos::parallel_reduce(
        Kokkos::TeamThreadRange(team, groups.offset(g), groups.offset(g + 1)),
        [&](int k, Sum& s) { s += value(groups.item(k), g); }, Kokkos::Sum<Sum>(sum));
    Kokkos::single(Kokkos::PerTeam(team), [&] { store(g, sum); });
  }
};

}  // namespace detail

/// store(g, sum of value(item, g) over the items of group g) for every group.
template <class Sum, class Value, class Store>
void sum_groups(const Exec& exec, const std::string& label, const Groups& groups, const Value& value,
                const Store& store) {
  if (groups.count() <= 0) return;
  if constexpr (runs_on_host) {
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, groups.count()),
                         detail::GroupSumOnHost<Sum, Value, Store>{groups, value, store});
  } else {
    Kokkos::parallel_for(label, Kokkos::TeamPolicy<Exec>(exec, groups.count(), 32),
                         detail::GroupSumByTeam<Sum, Value, Store>{groups, value, store});
  }
}

}  // namespace vug
