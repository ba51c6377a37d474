#pragma once
// Two launchers for one physics body: on a host, blocks of nodes whose inner loop the compiler vectorises; on a GPU,
// one node per thread. Sums are taken per block in a fixed order, so their bits do not depend on the thread count.
#include "kernels/launch/own_items.hpp"

#include <algorithm>
#include <string>
#include <type_traits>

namespace vug {

#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__) || !defined(__GNUC__) || defined(__clang__)
#define VUG_VECTORISE
#else
#define VUG_VECTORISE _Pragma("GCC ivdep")
#endif

inline constexpr int shortest_block = 32;
/// Threads of a GPU that add up a block or a row.
inline constexpr int threads_per_sum = 256;

/// Total of eight interleaved sums.
KOKKOS_FORCEINLINE_FUNCTION constexpr double sum_of_lanes(const double (&sum)[8]) {
  return ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
}

namespace detail {

/// Runs the nodes of a block in one loop. It copies the body first: no store of the loop can change a local copy, so
/// its constants and pointers stay in registers. Inside a kernel, copies of Views count no references.
template <class Body, bool vectorised = true>
struct NodeLoop {
  Body body;
  KOKKOS_FUNCTION void operator()(int first, int last) const {
    const Body local = body;
    if constexpr (vectorised) {
      VUG_VECTORISE
      for (int i = first; i < last; ++i) local(i);
    } else {
      for (int i = first; i < last; ++i) local(i);
    }
  }
};

template <class Body>
struct Block {
  Body body;
  int n, size;
  const int* listed = nullptr;  ///< numbers of the blocks that run; null: all do
  KOKKOS_FUNCTION void operator()(int item) const {
    const int first = (listed ? listed[item] : item) * size;
    body(first, first + size < n ? first + size : n);
  }
};

/// On a host: sum of body(i) over a block. Terms go to a buffer, so that the loop over nodes vectorises, and are then
/// added in eight interleaved sums.
template <class Body>
KOKKOS_FORCEINLINE_FUNCTION double sum_of_block(const Body& body, int first, int last) {
  constexpr int lanes = 8;
  double term[nodes_per_block];
  const int count = last - first;
  VUG_VECTORISE
  for (int i = 0; i < count; ++i) term[i] = static_cast<double>(body(first + i));
  double sum[lanes] = {};
  int i = 0;
  for (; i + lanes <= count; i += lanes)
    for (int l = 0; l < lanes; ++l) sum[l] += term[i + l];
  for (int l = 0; i < count; ++i, ++l) sum[l] += term[i];
  return sum_of_lanes(sum);
}

/// On a GPU: runs the item at one place.
template <class Body>
struct NodeOfBlocks {
  Body body;
  OwnItems own;
  KOKKOS_FUNCTION void operator()(int place) const {
    if (const int i = own(place); i >= 0) body(i);
  }
};

/// On a GPU: *total += sum of body(i) over a range, computed by a team.
template <class Team, class Body>
KOKKOS_FORCEINLINE_FUNCTION void add_by_team(const Team& team, int begin, int end, const Body& body, double* total) {
  double sum = 0;
  Kokkos::parallel_reduce(
      Kokkos::TeamThreadRange(team, begin, end), [&](int i, double& s) { s += static_cast<double>(body(i)); }, sum);
  Kokkos::single(Kokkos::PerTeam(team), [&] { *total += sum; });
}

/// The items of a block of a list; league ranks stand for all blocks, or for those listed.
struct ItemsOfBlock {
  int n;
  const int* listed;
  KOKKOS_FORCEINLINE_FUNCTION int number(int rank) const { return listed ? listed[rank] : rank; }
  KOKKOS_FORCEINLINE_FUNCTION int begin(int block) const { return block * nodes_per_block; }
  KOKKOS_FORCEINLINE_FUNCTION int end(int block) const { return begin(block + 1) < n ? begin(block + 1) : n; }
};

/// Adds up a block, or a row: on a host in parts of at most a block, on a GPU by a team.
template <class Items, class Body>
struct SumOfItems {
  using Team = typename Kokkos::TeamPolicy<Exec>::member_type;
  Items items;
  Body body;
  ScalarField<double> total;
  KOKKOS_FUNCTION void operator()(int rank) const {
    const Body local = body;
    const int k = items.number(rank), last = items.end(k);
    double sum = 0;
    for (int first = items.begin(k); first < last; first += nodes_per_block)
      sum += sum_of_block(local, first, first + nodes_per_block < last ? first + nodes_per_block : last);
    total(k) += sum;
  }
  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int k = items.number(team.league_rank());
    add_by_team(team, items.begin(k), items.end(k), body, &total(k));
  }
};

}  // namespace detail

/// Number of nodes per block of a list. Short lists (the bonds of a small rock, the links of an opening) have shorter
/// blocks, so that several threads get a share. It does not depend on the number of threads, because the ends of the
/// blocks decide which nodes the vectorised part of the loop rounds.
inline int block_of_list(int n) {
  constexpr int shares = 4;
  const int share = ((n + shares - 1) / shares + shortest_block - 1) / shortest_block * shortest_block;
  return share < nodes_per_block ? share : nodes_per_block;
}

/// Execution space of lists that are too short for more than one thread.
#ifdef KOKKOS_ENABLE_SERIAL
using ShortExec = std::conditional_t<shares_host_memory, Kokkos::Serial, Exec>;
#else
using ShortExec = Exec;  // the Kokkos of a distribution may be without the serial back end
#endif

/// On a host: runs body(first, last) for blocks [first, last) of `size` nodes of the list, which must be independent.
/// The shortest lists run without waking other threads, which would take longer than the work. Where processes share
/// the list, runs the blocks of nodes_per_block of this process instead.
template <class Body>
void for_each_block(const Exec& exec, const std::string& label, const Share& list, const Body& body, int size) {
  const int n = list.n;
  if (n <= 0 || list.blocks == 0) return;
  if (!list.whole())
    return Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, list.blocks),
                                detail::Block<Body>{body, n, nodes_per_block, list.block});
  const detail::Block<Body> blocks{body, n, size};
  if (n <= shortest_block)
    Kokkos::parallel_for(label, Kokkos::RangePolicy<ShortExec>(0, 1), blocks);
  else
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, (n + size - 1) / size), blocks);
}

/// Runs body(i) for the items i of a list. Iterations must be independent. Nothing is fenced. On a host bodies that
/// read and write scattered addresses are better not `vectorised`: gathers and scatters of vectors take several times
/// as long as single loads and stores.
template <bool vectorised = true, class Body>
void for_each_node(const Exec& exec, const std::string& label, const Share& list, const Body& body) {
  if (list.n <= 0 || list.blocks == 0) return;
  if constexpr (runs_on_host)
    for_each_block(exec, label, list, detail::NodeLoop<Body, vectorised>{body}, block_of_list(list.n));
  else if (list.whole())
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, list.n), body);
  else
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, OwnItems{list}.places()),
                         detail::NodeOfBlocks<Body>{body, {list}});
}

/// Runs body(team) for `count` teams of `threads` threads with `lanes` lanes each, or as many as the back end allows
/// for this body; of one thread on a host.
template <int lanes = 1, class Body>
void for_each_team(const Exec& exec, const std::string& label, int count, int threads, const Body& body) {
  using Policy = Kokkos::TeamPolicy<Exec>;
  const int width = std::min(lanes, Policy::vector_length_max());
  // queried once, because a query takes as long as a launch
  static const int most =
      shares_host_memory ? 1 : Policy(exec, count, 1, width).team_size_max(body, Kokkos::ParallelForTag{});
  Kokkos::parallel_for(label, Policy(exec, count, std::min(threads, most), width), body);
}

namespace detail {

/// Adds up `count` blocks or rows, on a GPU by teams of `threads`.
template <class Items, class Body>
void add_up(const Exec& exec, const std::string& label, int count, int threads, const SumOfItems<Items, Body>& sums) {
  if (count <= 0) return;
  if constexpr (runs_on_host)
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, count), sums);
  else
    for_each_team(exec, label, count, threads, sums);
}

}  // namespace detail

/// total(block) += sum of body(i) over the block's nodes, for the items i of a list of n; `total` has at least
/// block_count(n) entries. body(i) returns double or int and may also write node i. Same bits for any number of
/// host threads.
template <class Body>
void add_per_block(const Exec& exec, const std::string& label, const Share& list, const Body& body,
                   const ScalarField<double>& total) {
  detail::add_up(exec, label, list.whole() ? block_count(list.n) : list.blocks, threads_per_sum,
                 detail::SumOfItems<detail::ItemsOfBlock, Body>{{list.n, list.block}, body, total});
}

/// An entry of a field, as the body of a sum.
struct ValueOf {
  ScalarField<double> values;
  KOKKOS_FUNCTION double operator()(int i) const { return values(i); }
};

/// Sum of all entries in index order, read on the host: for monitors and ledgers, not inside a step.
double sum_in_order(const ScalarField<double>& values);

/// Sum of body(i) over the items i of a list of n: the same bits for any number of threads. Waits for the device.
template <class Body>
double sum_of_list(const Exec& exec, const std::string& label, int n, const Body& body) {
  const ScalarField<double> partial(Kokkos::view_alloc(exec, label), block_count(n));
  add_per_block(exec, label, n, body, partial);
  exec.fence();
  return sum_in_order(partial);
}

namespace detail {
struct AccumulateCounts {
  IndexList offset;
  KOKKOS_FUNCTION void operator()(int i, int& sum, bool last) const {
    sum += offset(i);
    if (last) offset(i) = sum;
  }
};
}  // namespace detail

/// Turns counts into offsets, in place: offset(i + 1), the length of list i, becomes the end of list i; offset(0) is
/// zero. Returns the total length, for which it waits.
inline int accumulate_counts(const Exec& exec, const std::string& label, const IndexList& offset) {
  int all = 0;
  Kokkos::parallel_scan(label, Kokkos::RangePolicy<Exec>(exec, 0, static_cast<int>(offset.extent(0))),
                        detail::AccumulateCounts{offset}, all);
  return all;
}

}  // namespace vug
