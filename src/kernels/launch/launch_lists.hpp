#pragma once
// Runs several lists in one launch, such as the stretches of a boundary: for short lists a launch takes longer than the
// work. A law has
//
// - Entry: the data of a list, plain pointers and numbers, because up to 16 entries are arguments of a kernel;
//
// - count(list): called on the host, the number of items of a list that was given to the launcher;
//
// - entry(list): called on the host, the Entry of a list; only where the lists are not given as entries;
//
// - law(entry, run): calls run(body) once, where body(i) is the work on item i of that list.
//
// The lists must be independent. Results are the same to the bit as with one launch for each list. Nothing is fenced.
#include "kernels/launch/launch.hpp"

#include <algorithm>
#include <span>
#include <type_traits>

namespace vug {

namespace detail {

/// Lists cut into blocks. Blocks are numbered consecutively over all lists.
template <class Entry>
struct Lists {
  static constexpr int most = 16;
  Entry entry[most];
  int count[most];           ///< items
  int size[most];            ///< items of a block
  int first[most + 1] = {};  ///< number of its first block
  int lists = 0, items = 0;

  void add(const Entry& list, int n, int block) {
    entry[lists] = list;
    count[lists] = n;
    size[lists] = block;
    first[lists + 1] = first[lists] + (n + block - 1) / block;
    ++lists;
    items += n;
  }
  int blocks() const { return first[lists]; }

  /// One block: its list and its items [begin, end).
  struct Part {
    int list, begin, end;
  };
  KOKKOS_FUNCTION Part part(int block) const {
    int l = 0;
    while (block >= first[l + 1]) ++l;
    const int begin = (block - first[l]) * size[l], end = begin + size[l];
    return {l, begin, end < count[l] ? end : count[l]};
  }
};

/// Calls launch(lists) for as many of `all` at a time as fit. block_of(n) is the length of the blocks of a list of n
/// items.
template <class Law, class Item, class BlockOf, class Launch>
void for_lists(std::span<const Item> all, const Law& law, const BlockOf& block_of, const Launch& launch) {
  using Some = Lists<typename Law::Entry>;
  for (auto next = all.begin(); next != all.end();) {
    Some some;
    for (; next != all.end() && some.lists < Some::most; ++next)
      if (const int n = law.count(*next); n > 0) {
        if constexpr (std::is_same_v<Item, typename Law::Entry>)
          some.add(*next, n, block_of(n));
        else
          some.add(law.entry(*next), n, block_of(n));
      }
    if (some.lists > 0) launch(some);
  }
}

template <class Law>
struct RunLists {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  Law law;
  Lists<typename Law::Entry> lists;
  KOKKOS_FUNCTION void operator()(int block) const {
    const auto part = lists.part(block);
    law(lists.entry[part.list], [&](const auto& body) {
      if constexpr (runs_on_host)
        NodeLoop<std::decay_t<decltype(body)>>{body}(part.begin, part.end);
      else
        body(part.begin);
    });
  }
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const auto part = lists.part(team.league_rank());
    law(lists.entry[part.list], [&](const auto& body) { body(team, part.begin); });
  }
};

template <class Law>
struct SumLists {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  Law law;
  Lists<typename Law::Entry> lists;
  KOKKOS_FUNCTION double* total(int list, int begin) const { return lists.entry[list].total + begin / nodes_per_block; }
  KOKKOS_FUNCTION void operator()(int block) const {
    const auto part = lists.part(block);
    law(lists.entry[part.list],
        [&](const auto& body) { *total(part.list, part.begin) += sum_of_block(body, part.begin, part.end); });
  }
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const auto part = lists.part(team.league_rank());
    law(lists.entry[part.list],
        [&](const auto& body) { add_by_team(team, part.begin, part.end, body, total(part.list, part.begin)); });
  }
};

}  // namespace detail

/// Runs body(i) for the items i of all lists, as for_each_node does for one.
template <class Law, class Item>
void for_each_of_lists(const Exec& exec, const std::string& label, std::span<const Item> all, const Law& law) {
  const auto block_of = [](int n) { return runs_on_host ? block_of_list(n) : 1; };
  detail::for_lists(all, law, block_of, [&](const auto& lists) {
    const detail::RunLists<Law> body{law, lists};
    if (runs_on_host && lists.items <= shortest_block)
      Kokkos::parallel_for(label, Kokkos::RangePolicy<ShortExec>(0, lists.blocks()), body);
    else
      Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, lists.blocks()), body);
  });
}

/// On a GPU: runs body(team, i) for the items i of all lists, each by a team of `threads` (for_each_team).
template <class Law, class Item>
void for_each_team_of_lists(const Exec& exec, const std::string& label, std::span<const Item> all, int threads,
                            const Law& law) {
  detail::for_lists(
      all, law, [](int) { return 1; },
      [&](const auto& lists) {
        for_each_team(exec, label, lists.blocks(), threads, detail::RunLists<Law>{law, lists});
      });
}

/// entry.total[block] += sum of body(i) over the items i of a block, for all lists, as add_per_block does for one.
template <class Law, class Item>
void add_per_block_of_lists(const Exec& exec, const std::string& label, std::span<const Item> all, const Law& law) {
  const auto block_of = [](int) { return nodes_per_block; };
  detail::for_lists(all, law, block_of, [&](const auto& lists) {
    const detail::SumLists<Law> body{law, lists};
    if constexpr (runs_on_host)
      Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, lists.blocks()), body);
    else
      for_each_team(exec, label, lists.blocks(), nodes_per_block, body);  // few blocks: a thread per item
  });
}

}  // namespace vug
