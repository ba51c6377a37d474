#pragma once
// Numbers the few nodes of the dense lattice that meet a condition, in node order. A pass that vectorises marks them.
// They are then searched eight marks at a time, most of which are zero.
#include "base/lattice.hpp"
#include "kernels/launch/row_launch.hpp"

#include <cstdint>
#include <cstring>
#include <string>

namespace vug {

/// (dense node) 1 where a node is marked, else 0.
using NodeMarks = Kokkos::View<std::uint8_t*>;

namespace detail {

inline constexpr int marks_per_word = 8;
static_assert(Lattice::pad % marks_per_word == 0, "rows end with a word");

KOKKOS_FORCEINLINE_FUNCTION std::uint64_t word_of(const NodeMarks& marks, int word) {
  std::uint64_t bytes;
  std::memcpy(&bytes, &marks(marks_per_word * word), sizeof bytes);
  return bytes;
}

template <class Holds>
struct MarkNodes {
  Holds holds;
  NodeMarks marks;
  KOKKOS_FUNCTION void operator()(int n) const { marks(n) = static_cast<std::uint8_t>(holds(n)); }
};

struct CountMarks {
  NodeMarks marks;
  KOKKOS_FUNCTION void operator()(int word, int& count) const { count += Kokkos::popcount(word_of(marks, word)); }
};

template <class Take>
struct TakeMarked {
  NodeMarks marks;
  Take take;
  KOKKOS_FUNCTION void operator()(int word, int& running, bool last) const {
    const std::uint64_t bytes = word_of(marks, word);
    if (last && bytes != 0) {
      int number = running;
      for (int i = 0; i < marks_per_word; ++i)
        if (const int n = marks_per_word * word + i; marks(n)) take(number++, n);
    }
    running += Kokkos::popcount(bytes);
  }
};

}  // namespace detail

/// The nodes inside the lattice for which holds(node) is true.
template <class Holds>
NodeMarks mark_nodes(const Exec& exec, const std::string& label, const Lattice& lattice, const Holds& holds) {
  NodeMarks marks(Kokkos::view_alloc(exec, label), lattice.size());
  for_each_dense_node(exec, label, lattice, detail::MarkNodes<Holds>{holds, marks});
  return marks;
}

/// How many nodes are marked; waits for the device.
inline int count_marked(const Exec& exec, const std::string& label, const NodeMarks& marks) {
  int count = 0;
  const int words = static_cast<int>(marks.extent(0)) / detail::marks_per_word;
  Kokkos::parallel_reduce(label, Kokkos::RangePolicy<Exec>(exec, 0, words), detail::CountMarks{marks}, count);
  return count;
}

/// Calls take(k, node) for every marked node, the k-th in node order.
template <class Take>
void take_marked(const Exec& exec, const std::string& label, const NodeMarks& marks, const Take& take) {
  const int words = static_cast<int>(marks.extent(0)) / detail::marks_per_word;
  Kokkos::parallel_scan(label, Kokkos::RangePolicy<Exec>(exec, 0, words), detail::TakeMarked<Take>{marks, take});
}

}  // namespace vug
