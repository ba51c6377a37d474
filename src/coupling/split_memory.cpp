// What a rank keeps in memory of fields that have room for all nodes.
#include "coupling/split.hpp"
#include "kernels/base/pages.hpp"

#include <algorithm>

namespace vug {

namespace {

/// visit(data, bytes) of what lies between ascending runs of slots, where it is at least as long.
template <class Visit>
void visit_gaps(const Runs& runs, void* values, std::size_t bytes, std::size_t slots, std::size_t shortest,
                const Visit& visit) {
  std::size_t end = 0;  // of the runs until now
  const auto gap = [&](std::size_t next) {
    if (next > end && (next - end) * bytes >= shortest)
      visit(static_cast<char*>(values) + end * bytes, (next - end) * bytes);
  };
  for (const auto& [first, last] : runs) {
    gap(first);
    end = std::max(end, static_cast<std::size_t>(last));
  }
  gap(slots);
}

}  // namespace

Runs Split::own_slots(const Owners& owners, int planes, std::size_t stride) const {
  Runs runs;
  for (int p = 0; p < planes; ++p)
    for (const auto& [first, last] : owners[ranks_.rank()]) {
      const int at = static_cast<int>(p * stride);
      runs.emplace_back(at + first, at + last);
    }
  return runs;
}

void Split::let_go(const Runs& own, const Halos& halos, void* values, std::size_t bytes, std::size_t slots) {
  // A node at a side in every row would keep large pages whole; not for less, as each part of another kind counts.
  constexpr std::size_t large = 4 << 20, small = 16 << 10;
  visit_gaps(own, values, bytes, slots, large, keep_pages_small);
  Runs kept = own;
  for (const Halo* halo : halos)
    for (const int slot : halo->taken_slots()) kept.emplace_back(slot, slot + 1);
  std::sort(kept.begin(), kept.end());
  visit_gaps(kept, values, bytes, slots, small, give_back_pages);
}

}  // namespace vug
