#pragma once
// Eight fluid nodes at a time on hosts with AVX-512. Walls apart, the slots from which eight consecutive nodes pull one
// direction lie within two runs of eight, almost always (99.9 % in rock of three-node pathways): two loads and a
// permutation of registers then take the place of eight loads, a permutation and masked stores that of eight stores.
// The processor's own gathers and scatters are no faster than single loads and stores.
#include "kernels/eight_lanes.hpp"
#include "kernels/unroll.hpp"
#include "kernels/velocity_set.hpp"

#include <cstdint>

namespace vug {

inline constexpr bool has_source_windows = has_eight_lanes;
inline constexpr int nodes_per_window = eight_lanes;

/// Where eight consecutive nodes, the first a multiple of eight, pull one direction from: FluidNodes::source of them
/// once more, in 20 bytes instead of 32. Numbers 0 to 7 are the slots from `first` on, 8 to 15 those from first + gap.
struct SourceWindow {
  int first = -1;             ///< -1: the slots do not lie in two runs
  std::uint32_t from = 0;     ///< 4 bits per node: the number of its slot
  std::uint32_t to[2] = {};   ///< per run: 3 bits per slot, its node; bit 24 + slot: has one
  std::uint32_t bounced : 8;  ///< bit per node: pulls from its own opposite slot instead
  std::uint32_t gap : 24;

  static constexpr int owned_from = 24, widest_gap = (1 << 24) - 1;
  KOKKOS_FORCEINLINE_FUNCTION SourceWindow() : bounced(0), gap(nodes_per_window) {}
  KOKKOS_FORCEINLINE_FUNCTION int run(int number) const { return number == 0 ? first : first + static_cast<int>(gap); }
};

/// The window over eight entries of FluidNodes::source of one direction, whose slots are [plane, plane + capacity).
KOKKOS_INLINE_FUNCTION SourceWindow source_window(const int* source, int plane, int capacity) {
  const auto inside = [&](int slot) { return slot >= plane && slot < plane + capacity; };
  SourceWindow w;
  int first = plane + capacity - 2 * nodes_per_window, second = plane + capacity - nodes_per_window;
  for (int l = 0; l < nodes_per_window; ++l)
    if (inside(source[l]) && source[l] < first) first = source[l];
  for (int l = 0; l < nodes_per_window; ++l)
    if (inside(source[l]) && source[l] >= first + nodes_per_window && source[l] < second) second = source[l];
  for (int l = 0; l < nodes_per_window; ++l) {
    if (!inside(source[l])) {
      w.bounced |= 1u << l;
      continue;
    }
    const int run = source[l] < first + nodes_per_window ? 0 : 1, slot = source[l] - (run == 0 ? first : second);
    if (slot >= nodes_per_window) return {};
    w.from |= static_cast<std::uint32_t>(run * nodes_per_window + slot) << 4 * l;
    w.to[run] |= static_cast<std::uint32_t>(l) << 3 * slot | 1u << (SourceWindow::owned_from + slot);
  }
  if (w.to[1] == 0) second = first + nodes_per_window;
  if (second - first > SourceWindow::widest_gap) return {};
  w.first = first;
  w.gap = static_cast<std::uint32_t>(second - first);
  return w;
}

/// Populations of eight consecutive nodes over a velocity set, and how they are fetched and put back.
template <class T, class Set>
struct EightNodes {
  const SourceWindow* windows;  ///< (eight nodes, direction - 1)
  const int* source;            ///< FluidNodes::source, where a window does not do
  int capacity;

  /// What arrives at nodes i .. i + 7, i a multiple of eight.
  void pull(const T* f, int i, T (&g)[Set::Q][nodes_per_window]) const {
    using E = Eight<T>;
    const SourceWindow* const window = windows + i;
    E::store(g[0], E::load(f + i));
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const SourceWindow& w = window[q - 1];
      if (w.first < 0) [[unlikely]] {
        for (int l = 0; l < nodes_per_window; ++l) g[q][l] = f[source[q * capacity + i + l]];
        continue;
      }
      const auto pulled = E::pick(w.from, E::load(f + w.run(0)), E::load(f + w.run(1)));
      E::store(g[q], E::blend(w.bounced, pulled, E::load(f + Set::opposite(q) * capacity + i)));
    }
  }

  /// `field` (fluid) at the nodes that the directions of i .. i + 7 come from, into `value` from `at` on; at a wall or
  /// a side that of the node itself. Of directions other than those that `matters` says true of, nothing.
  template <int some, class Matters>
  void upstream(const T* field, int i, T (&value)[Set::Q][some], int at, const Matters& matters) const {
    using E = Eight<T>;
    const auto own = E::load(field + i);
    E::store(value[0] + at, own);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      if (!matters(q)) continue;
      const SourceWindow& w = windows[i + q - 1];
      const int plane = q * capacity;
      if (w.first < 0) [[unlikely]] {
        for (int l = 0; l < nodes_per_window; ++l) {
          const int from = source[plane + i + l] - plane;
          value[q][at + l] = field[from >= 0 && from < capacity ? from : i + l];
        }
        continue;
      }
      const auto there = E::pick(w.from, E::load(field + (w.run(0) - plane)), E::load(field + (w.run(1) - plane)));
      E::store(value[q] + at, E::blend(w.bounced, there, own));
    }
  }

  /// Leaves what goes out against direction q where what came in along q was. Stores without a lane cost less than
  /// branches that the processor guesses wrong.
  void push(T* f, int i, const T (&g)[Set::Q][nodes_per_window]) const {
    using E = Eight<T>;
    const SourceWindow* const window = windows + i;
    E::store(f + i, E::load(g[0]));
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const SourceWindow& w = window[q - 1];
      const int opposite = Set::opposite(q);
      if (w.first < 0) [[unlikely]] {
        for (int l = 0; l < nodes_per_window; ++l) f[source[q * capacity + i + l]] = g[opposite][l];
        continue;
      }
      const auto out = E::load(g[opposite]);
      const std::uint32_t near = w.to[0] >> SourceWindow::owned_from, far = w.to[1] >> SourceWindow::owned_from;
      E::store(f + w.run(0), near, E::pick(w.to[0], out));
      E::store(f + w.run(1), far, E::pick(w.to[1], out));
      E::store(f + opposite * capacity + i, w.bounced, out);
    }
  }
};

}  // namespace vug
