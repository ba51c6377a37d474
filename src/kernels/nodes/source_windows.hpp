#pragma once
// Packs of consecutive fluid nodes: how a host gathers and scatters by the table of sources. Apart from walls, the
// slots from which eight nodes pull one direction almost always lie within two runs of eight slots (99.9 % in rock with
// pathways of three nodes). Where the processor has permutations and masked stores (AVX-512), two loads and a
// permutation replace eight loads, and a permutation and masked stores replace eight stores. AVX-512's own gathers and
// scatters are no faster than single loads and stores, which other processors use.
#include "base/unroll.hpp"
#include "base/velocity_set.hpp"
#include "kernels/launch/prefetch.hpp"
#include "kernels/packs/pack.hpp"

#include <array>
#include <cstdint>

namespace vug {

inline constexpr bool has_source_windows = runs_on_host && packs_permute;
inline constexpr int nodes_per_window = pack_size;

/// The slots from which eight consecutive nodes, the first a multiple of eight, pull one direction: their entries of
/// FluidNodes::source in 24 bytes instead of 32. Numbers 0 to 7 are the slots from `near` on, 8 to 15 those from `far`
/// on.
struct SourceWindow {
  static constexpr std::uint32_t none = 0xffffffff;

  std::uint32_t near = none, far = 0;          ///< first slots of the two runs; none: two are not enough
  std::uint32_t from = 0;                      ///< 4 bits per node: the number of its slot
  std::uint32_t to_near = 0, to_far = 0;       ///< 3 bits per slot of a run: its node
  std::uint8_t owned_near = 0, owned_far = 0;  ///< bit per slot of a run: a node pulls from it
  std::uint8_t bounced = 0;                    ///< bit per node: pulls from its own opposite slot instead

  KOKKOS_FORCEINLINE_FUNCTION bool is_irregular() const { return near == none; }
  friend bool operator==(const SourceWindow&, const SourceWindow&) = default;
};

/// The window over eight entries of FluidNodes::source of one direction, whose slots are [plane, plane + capacity). Its
/// runs begin at multiples of `step` slots of the plane.
KOKKOS_INLINE_FUNCTION SourceWindow source_window(const int* source, int plane, int capacity, int step) {
  const auto inside = [&](int slot) { return slot >= plane && slot < plane + capacity; };
  const auto run_of = [&](int slot) { return slot - (slot - plane) % step; };
  SourceWindow w;
  int near = plane + capacity - 2 * nodes_per_window, far = plane + capacity - nodes_per_window;
  for (int l = 0; l < nodes_per_window; ++l)
    if (inside(source[l]) && source[l] < near) near = run_of(source[l]);
  for (int l = 0; l < nodes_per_window; ++l)
    if (inside(source[l]) && source[l] >= near + nodes_per_window && source[l] < far) far = run_of(source[l]);
  for (int l = 0; l < nodes_per_window; ++l) {
    const auto node = static_cast<std::uint32_t>(l);
    if (!inside(source[l])) {
      w.bounced = static_cast<std::uint8_t>(w.bounced | 1u << node);
      continue;
    }
    const bool is_near = source[l] < near + nodes_per_window;
    const auto slot = static_cast<std::uint32_t>(source[l] - (is_near ? near : far));
    if (slot >= nodes_per_window) return {};
    w.from |= (is_near ? slot : nodes_per_window + slot) << 4 * node;
    (is_near ? w.to_near : w.to_far) |= node << 3 * slot;
    std::uint8_t& owned = is_near ? w.owned_near : w.owned_far;
    owned = static_cast<std::uint8_t>(owned | 1u << slot);
  }
  w.near = static_cast<std::uint32_t>(near);
  w.far = static_cast<std::uint32_t>(w.owned_far == 0 ? near + nodes_per_window : far);
  return w;
}

/// The same, with runs aligned to the cache where two such runs are enough.
KOKKOS_INLINE_FUNCTION SourceWindow source_window(const int* source, int plane, int capacity) {
  const SourceWindow aligned = source_window(source, plane, capacity, nodes_per_window);
  return aligned.is_irregular() ? source_window(source, plane, capacity, 1) : aligned;
}

/// Loads and stores the populations of eight consecutive nodes of a velocity set: by windows, or one by one.
template <class T, class Set, bool by_windows = has_source_windows>
struct SourcePacks {
  const SourceWindow* windows;  ///< (eight nodes, direction - 1)
  const int* source;            ///< FluidNodes::source
  int capacity;

  using P = PackOf<T>;

  /// Whether a pack may load from a run that the pack before it stores to (other slots of it).
  static constexpr bool runs_overlap = by_windows;

  /// Loads what arrives at nodes i .. i + 7, i a multiple of eight.
  KOKKOS_FORCEINLINE_FUNCTION void pull(const T* f, int i, Pack<T> (&g)[Set::Q]) const {
    if constexpr (by_windows) announce(windows + i + windows_ahead);
    g[0] = P::load(f + i);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      if constexpr (by_windows)
        if (const SourceWindow& w = windows[i + q - 1]; !w.is_irregular()) [[likely]] {
          const Pack<T> pulled = P::pick(w.from, P::load(f + w.near), P::load(f + w.far));
          g[q] = P::blend(w.bounced, pulled, P::load(f + Set::opposite(q) * capacity + i));
          continue;
        }
      g[q] = P::gather(f, source + q * capacity + i);
    }
  }

  /// For the nodes i .. i + some - 1 (i a multiple of eight) and each direction q, stores the values of two fields
  /// (fluid) at the node that q comes from in value[field][q]; at a wall or a side, the values of the node itself.
  /// Skips the q and fields for which `matters(q, field)` is false.
  template <int some, class Matters>
  void upstream(const std::array<const T*, 2>& fields, int i, T (&value)[2][Set::Q][some],
                const Matters& matters) const {
    for (int n = 0; n < 2; ++n)
      for (int l = 0; l < some; l += pack_size) P::store(value[n][0] + l, P::load(fields[n] + i + l));
    if constexpr (by_windows) {
      for (int l = 0; l < some; l += pack_size) {
        announce(windows + i + l + windows_ahead);
        upstream_by_windows(fields, i, value, l, matters);
      }
    } else {
      VUG_UNROLL
      for (int q = 1; q < Set::Q; ++q) {
        for (int l = 0; l < some; l += pack_size) prefetch(source + q * capacity + i + l + windows_ahead);
        upstream_one_by_one<some>(fields, q, i, value, 0, matters);
      }
    }
  }

  /// Stores what leaves against direction q in the slot from which direction q was pulled. Stores with an empty mask
  /// cost less than mispredicted branches.
  KOKKOS_FORCEINLINE_FUNCTION void push(T* f, int i, const Pack<T> (&g)[Set::Q]) const {
    P::store(f + i, g[0]);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const int opposite = Set::opposite(q);
      const Pack<T> out = g[opposite];
      if constexpr (by_windows)
        if (const SourceWindow& w = windows[i + q - 1]; !w.is_irregular()) [[likely]] {
          P::store(f + w.near, w.owned_near, P::pick(w.to_near, out));
          P::store(f + w.far, w.owned_far, P::pick(w.to_far, out));
          P::store(f + opposite * capacity + i, w.bounced, out);
          continue;
        }
      P::scatter(f, source + q * capacity + i, out);
    }
  }

 private:
  /// upstream() of nodes i + at .. i + at + 7.
  template <int some, class Matters>
  void upstream_by_windows(const std::array<const T*, 2>& fields, int i, T (&value)[2][Set::Q][some], int at,
                           const Matters& matters) const {
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const SourceWindow& w = windows[i + at + q - 1];
      if (w.is_irregular()) [[unlikely]] {
        upstream_one_by_one<pack_size>(fields, q, i, value, at, matters);
        continue;
      }
      for (int n = 0; n < 2; ++n) {
        if (!matters(q, n)) continue;
        const T* const run = fields[n] - q * capacity;
        const Pack<T> there = P::pick(w.from, P::load(run + w.near), P::load(run + w.far));
        P::store(value[n][q] + at, P::blend(w.bounced, there, P::load(fields[n] + i + at)));
      }
    }
  }

  /// upstream() along direction q of nodes i + at .. i + at + count - 1, by the table of sources.
  template <int count, int some, class Matters>
  KOKKOS_FORCEINLINE_FUNCTION void upstream_one_by_one(const std::array<const T*, 2>& fields, int q, int i,
                                                       T (&value)[2][Set::Q][some], int at,
                                                       const Matters& matters) const {
    const int plane = q * capacity, first = i + at;
    alignas(64) int node[count];
    for (int l = 0; l < count; ++l) {
      const int from = source[plane + first + l] - plane;
      node[l] = static_cast<unsigned>(from) < static_cast<unsigned>(capacity) ? from : first + l;
    }
    if (Set::c(q, 1) == 0 && along_row<count>(fields, q, node, first, value, at, matters)) return;
    for (int l = 0; l < count; l += pack_size)
      for (int n = 0; n < 2; ++n)
        if (matters(q, n)) P::store(value[n][q] + at + l, P::gather(fields[n], node + l));
  }

  /// The same where every `node` is the node itself or its neighbour in the list, as in a row except at its ends and
  /// among newborn nodes: loads whole packs instead of single numbers. Elsewhere does nothing and returns false.
  template <int count, int some, class Matters>
  KOKKOS_FORCEINLINE_FUNCTION bool along_row(const std::array<const T*, 2>& fields, int q, const int (&node)[count],
                                             int first, T (&value)[2][Set::Q][some], int at,
                                             const Matters& matters) const {
    const int step = -Set::c(q, 0);
    if (first + step < 0 || first + step + count > capacity) return false;
    int elsewhere = 0;
    for (int l = 0; l < count; ++l) elsewhere |= (node[l] != first + l) & (node[l] != first + l + step);
    if (elsewhere != 0) [[unlikely]]
      return false;
    for (int n = 0; n < 2; ++n) {
      if (!matters(q, n)) continue;
      const T *const own = fields[n] + first, *const next = own + step;
      T* const to = value[n][q] + at;
      for (int l = 0; l < count; ++l) {
        const T here = own[l], there = next[l];
        to[l] = node[l] == first + l ? here : there;
      }
    }
    return true;
  }

  static constexpr int windows_ahead = 8 * nodes_per_window;

  /// Prefetches windows: among so many streams the processor does not predict this one.
  KOKKOS_FORCEINLINE_FUNCTION static void announce(const SourceWindow* later) {
    constexpr int line = 64, bytes = (Set::Q - 1) * static_cast<int>(sizeof(SourceWindow));
    VUG_UNROLL
    for (int b = 0; b < bytes; b += line) prefetch(reinterpret_cast<const char*>(later) + b);
  }
};

}  // namespace vug
