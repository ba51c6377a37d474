#pragma once
// Sums over the nodes of groups (of a triangle, of a part of it) in a fixed order: the same bits in every run.
#include "coupling/rock_map.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/launch/prefetch.hpp"

#include <optional>
#include <string>

namespace vug {

namespace detail {

/// Sums one group, with four partial sums in turn.
template <class T, class Store>
struct RunSumOnHost {
  NodeGroups groups;
  const int* only;  ///< null: all
  Kokkos::View<const T*> values;
  Store store;
  /// Prefetches: every run is in another row.
  KOKKOS_FORCEINLINE_FUNCTION void announce(int r) const {
    constexpr int ahead = 64;
    if (r + ahead >= static_cast<int>(groups.first.extent(0))) return;
    const int first = groups.first(r + ahead);
    prefetch_far(&values(first));
    prefetch_far(&values(first + groups.length(r + ahead) - 1));
  }
  KOKKOS_FUNCTION void operator()(int item) const {
    constexpr int lanes = 4;
    const int g = only ? only[item] : item;
    double sum[lanes] = {};
    for (int r = groups.offset(g); r < groups.offset(g + 1); ++r) {
      announce(r);
      const T* const run = values.data() + groups.first(r);
      const int length = groups.length(r);
      int i = 0;
      for (; i + lanes <= length; i += lanes)
        for (int l = 0; l < lanes; ++l) sum[l] += static_cast<double>(run[i + l]);
      for (; i < length; ++i) sum[0] += static_cast<double>(run[i]);
    }
    store(g, (sum[0] + sum[1]) + (sum[2] + sum[3]));
  }
};

/// Sums one group by a team: its threads take runs, their vector lanes the nodes of a run.
template <class T, class Store>
struct RunSumByTeam {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  NodeGroups groups;
  const int* only;  ///< null: all
  Kokkos::View<const T*> values;
  Store store;
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int g = only ? only[team.league_rank()] : team.league_rank();
    double sum = 0;
    Kokkos::parallel_reduce(
        Kokkos::TeamThreadRange(team, groups.offset(g), groups.offset(g + 1)),
        [&](int r, double& runs) {
          double run = 0;
          const int first = groups.first(r);
          Kokkos::parallel_reduce(
              Kokkos::ThreadVectorRange(team, groups.length(r)),
              [&](int i, double& s) { s += static_cast<double>(values(first + i)); }, run);
          runs += run;
        },
        sum);
    Kokkos::single(Kokkos::PerTeam(team), [&] { store(g, sum); });
  }
};

}  // namespace detail

/// Calls store(g, sum of `values` (dense node) over the nodes of group g) for every group, or those listed in `only`.
template <class T, class Store>
void sum_runs(const Exec& exec, const std::string& label, const NodeGroups& groups, const ScalarField<T>& values,
              const Store& store, const std::optional<IndexList>& only = {}) {
  const int count = only ? static_cast<int>(only->extent(0)) : groups.count();
  const int* const list = only ? only->data() : nullptr;
  if (count <= 0) return;
  if constexpr (runs_on_host)
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, count),
                         detail::RunSumOnHost<T, Store>{groups, list, values, store});
  else
    for_each_team<8>(exec, label, count, 4, detail::RunSumByTeam<T, Store>{groups, list, values, store});
}

}  // namespace vug
