#include "coupling/shared_field.hpp"

#include "base/pages.hpp"

#include <algorithm>
#include <cstring>

namespace vug::detail {

namespace {

/// Calls visit(first, last) for the gaps between ascending runs, up to `end`.
template <class Visit>
void visit_gaps(const Runs& runs, int end, const Visit& visit) {
  int at = 0;
  for (const auto& [first, last] : runs) {
    if (first > at) visit(at, first);
    at = std::max(at, last);
  }
  if (end > at) visit(at, end);
}

/// The gaps between ascending runs, up to `end`.
Runs gaps(const Runs& runs, int end) {
  Runs between;
  visit_gaps(runs, end, [&](int first, int last) { between.emplace_back(first, last); });
  return between;
}

int stride_of(const Shares& shares, std::size_t count) {
  return static_cast<int>(count / shares.planes);
}

/// The slots of a rank, in all planes, ascending.
Runs slots_of_rank(const Shares& shares, int rank, int stride) {
  Runs runs;
  for (int p = 0; p < shares.planes; ++p)
    for (const auto& [first, last] : shares.owners[rank]) runs.emplace_back(p * stride + first, p * stride + last);
  return runs;
}

void add_halos(const Shares& shares, int stride, Runs& runs) {
  for (const Halo& halo : shares.halos)
    for (const int slot : halo.taken_slots())
      for (int p = 0; p < (shares.halos_of_plane ? shares.planes : 1); ++p)
        runs.emplace_back(p * stride + slot, p * stride + slot + 1);
  std::sort(runs.begin(), runs.end());
}

/// The slots that a rank takes from a file: its own, those that come to it from others, and, on the first rank, which
/// writes them again, those of no rank.
Runs taken_from_file(const Ranks& ranks, const Shares& shares, std::size_t count) {
  const int stride = stride_of(shares, count);
  Runs taken = slots_of_rank(shares, ranks.rank(), stride);
  if (ranks.first()) {
    Runs of_others;
    for (int r = 1; r < ranks.size(); ++r) {
      const Runs runs = slots_of_rank(shares, r, stride);
      of_others.insert(of_others.end(), runs.begin(), runs.end());
    }
    std::sort(of_others.begin(), of_others.end());
    taken = gaps(of_others, static_cast<int>(count));
  }
  add_halos(shares, stride, taken);
  return taken;
}

/// Calls visit(first, last) for pieces of a few MiB each.
template <class Visit>
void visit_pieces(int count, std::size_t bytes, const Visit& visit) {
  constexpr std::size_t most = 4 << 20;
  const int piece = std::max(1, static_cast<int>(most / bytes));
  for (int first = 0; first < count; first += piece) visit(first, std::min(first + piece, count));
}

}  // namespace

void save_shared(const Ranks& ranks, const Shares& shares, const Slots& slots, const TakeBytes& take) {
  const int stride = stride_of(shares, slots.count);
  std::vector<std::byte> room, whole;
  for (int p = 0; p < shares.planes; ++p)
    visit_pieces(stride, slots.bytes, [&](int first, int last) {
      const std::size_t at = static_cast<std::size_t>(p) * stride + first, count = last - first;
      const std::byte* const own = slots.look(at, count, room);
      if (ranks.first()) whole.assign(own, own + count * slots.bytes);
      ranks.bring(shares.owners, first, last, slots.bytes, own, whole.data());
      take(whole);
    });
}

void load_shared(const Ranks& ranks, const Shares& shares, const Slots& slots, const GiveBytes& give) {
  const Runs taken = taken_from_file(ranks, shares, slots.count);
  auto run = taken.begin();
  std::vector<std::byte> piece;
  visit_pieces(static_cast<int>(slots.count), slots.bytes, [&](int first, int last) {
    while (run != taken.end() && run->second <= first) ++run;
    if (run == taken.end() || run->first >= last) return;
    piece.resize((last - first) * slots.bytes);
    give(first * slots.bytes, piece);
    slots.check(piece);
    if constexpr (!runs_on_host) {
      slots.put(first, piece);  // a GPU has memory for the whole field
    } else {
      for (auto part = run; part != taken.end() && part->first < last; ++part) {
        const int from = std::max(part->first, first), to = std::min(part->second, last);
        slots.put(from, std::span(piece).subspan((from - first) * slots.bytes, (to - from) * slots.bytes));
      }
    }
  });
}

void let_go(const Ranks& ranks, const Shares& shares, void* values, std::size_t bytes, std::size_t count) {
  // Pages in long gaps are made small, because a node at a side in every row would keep large ones whole. Not in short
  // gaps, because the system counts each part with pages of another kind.
  constexpr std::size_t large = 4 << 20, small = 16 << 10;
  const auto visit = [&](const Runs& runs, std::size_t shortest, auto what) {
    visit_gaps(runs, static_cast<int>(count), [&](int first, int last) {
      if ((last - first) * bytes >= shortest) what(static_cast<char*>(values) + first * bytes, (last - first) * bytes);
    });
  };
  const int stride = stride_of(shares, count);
  Runs kept = slots_of_rank(shares, ranks.rank(), stride);
  visit(kept, large, keep_pages_small);
  add_halos(shares, stride, kept);
  visit(kept, small, give_back_pages);
}

}  // namespace vug::detail
