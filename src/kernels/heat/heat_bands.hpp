#pragma once
// Conduction in place, on a host. There the cache fetches what a store is about to overwrite, so that a second lattice
// would cost half as much traffic again, besides its memory.
//
// Bands of rows are computed side by side, each of them row by row upwards. A node pulls old populations from its
// neighbours. Those that are overwritten before that are set aside: from the current row what moves to the right and
// from the row below what moves upwards, in lines that stay in the cache; and, before any band begins, from the rows
// beside it what moves into it. All others are still there. Afterwards every population is at its place, and the
// results do not depend on the bands, to the bit.
#include "kernels/heat/heat_kernels.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/launch/prefetch.hpp"

namespace vug {

/// Number of lattices of populations that HeatFields holds; with two, a step reads one and writes the other.
inline constexpr int heat_lattices = runs_on_host ? 1 : 2;

/// Copies a row with the halo on either side.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION void copy_line(const T* from, T* to, int nx) {
  VUG_VECTORISE
  for (int x = -1; x <= nx; ++x) to[x] = from[x];
}

/// The lines that a band sets aside, rows of the lattice's pitch. Per direction upwards there are two, alternately of
/// the row below and of the current row, and per direction downwards one, of the row above the band. Together they are
/// a tenth of a number per node on D2Q5 and three tenths on D2Q9, for bands of 32 rows.
template <class T, class Set>
struct BandLines {
  static constexpr int rising = Set::Q == D2Q9::Q ? 3 : 1;  ///< directions with c_y = 1; as many with -1
  static constexpr int count = 3 * rising;

  /// Number of q among the directions that move up, or among those that move down.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int rank(int q) { return q < 5 ? 0 : 1 + (q + 1) % 2; }

  T* first;  ///< x = 0 of the first line
  int pitch;

  KOKKOS_FORCEINLINE_FUNCTION T* upward(int turn, int q) const { return first + (turn * rising + rank(q)) * pitch; }
  KOKKOS_FORCEINLINE_FUNCTION T* above(int q) const { return first + (2 * rising + rank(q)) * pitch; }
};

/// The bands of a lattice and the populations that its conduction in place reads and writes.
template <class T, class Set>
struct HeatBands {
  Lattice lattice;
  int first, rows, count;
  ScalarField<T> g, lines;

  explicit HeatBands(const HeatFields<T>& fields)
      : lattice(fields.lattice),
        first(fields.first_row),
        rows(fields.rows),
        count(fields.bands < fields.rows ? fields.bands : fields.rows),
        g(fields.g),
        lines(fields.lines) {}

  /// First row of a band, or the end of the last.
  KOKKOS_FORCEINLINE_FUNCTION int first_row(int band) const {
    return first + static_cast<int>(static_cast<long long>(band) * rows / count);
  }
  KOKKOS_FORCEINLINE_FUNCTION BandLines<T, Set> lines_of(int band) const {
    const std::size_t line = static_cast<std::size_t>(band) * BandLines<T, Set>::count;
    return {lines.data() + line * lattice.pitch + Lattice::pad, lattice.pitch};
  }
  /// Population q at x = 0 of a row.
  KOKKOS_FORCEINLINE_FUNCTION T* row(int q, int y) const { return g.data() + q * lattice.size() + lattice.node(0, y); }
};

/// Sets aside what moves into a band from the rows below and above it.
template <class T, class Set>
struct SetAsideBesideBand {
  HeatBands<T, Set> bands;
  KOKKOS_FUNCTION void operator()(int band) const {
    const BandLines<T, Set> lines = bands.lines_of(band);
    for (int q = 1; q < Set::Q; ++q) {
      if (Set::c(q, 1) > 0) copy_line(bands.row(q, bands.first_row(band) - 1), lines.upward(0, q), bands.lattice.nx);
      if (Set::c(q, 1) < 0) copy_line(bands.row(q, bands.first_row(band + 1)), lines.above(q), bands.lattice.nx);
    }
  }
};

/// Conduction of a band of rows. `rows`, the work that follows in every row, gets each part of a row while it is in the
/// nearest cache.
template <class T, class Set, class Matter, class Rows>
struct ConductBand {
  /// Number of nodes of a row that are computed at a time, with some of their data staged in the nearest cache: four of
  /// its lines. Longer segments read one memory stream after the other, and shorter ones are mostly beginnings and
  /// ends.
  static constexpr int segment = 256 / sizeof(T);

  HeatBands<T, Set> bands;
  Matter matter;
  Rows rows;

  KOKKOS_FUNCTION void operator()(int band) const {
    const Matter local = matter;
    const BandLines<T, Set> lines = bands.lines_of(band);
    const int first = bands.first_row(band), last = bands.first_row(band + 1) - 1;
    for (int y = first; y <= last; ++y) {
      auto following = rows.row(y);
      conduct(row_at(y, y == last, (y - first) % 2, lines), local,
              [&, start = bands.lattice.node(0, y)](int x) { following.up_to(start + x); });
      following.end();
    }
  }

 private:
  /// Pointers to the data of a row, at x = 0. What moves to the right (direction 1) arrives from what `conduct` sets
  /// aside.
  struct Row {
    T* g[Set::Q];             ///< its populations
    const T* pulled[Set::Q];  ///< what arrives at it
    T* kept[Set::Q];          ///< where it sets aside what moves upwards; not set for other directions
    const std::uint8_t* kind;
    int node;  ///< dense index at x = 0
  };

  KOKKOS_FORCEINLINE_FUNCTION Row row_at(int y, bool is_last, int turn, const BandLines<T, Set>& lines) const {
    const int nx = bands.lattice.nx, pitch = bands.lattice.pitch, node = bands.lattice.node(0, y);
    Row row;
    row.kind = &matter.kind(node);
    row.node = node;
    VUG_UNROLL
    for (int q = 0; q < Set::Q; ++q) {
      row.g[q] = bands.row(q, y);
      row.pulled[q] = row.g[q] - Set::c(q, 0);
      if (Set::c(q, 1) < 0) row.pulled[q] = (is_last ? lines.above(q) : row.g[q] + pitch) - Set::c(q, 0);
      if (Set::c(q, 1) > 0) {
        row.pulled[q] = lines.upward(turn, q) - Set::c(q, 0);
        row.kept[q] = lines.upward(1 - turn, q);
        row.kept[q][-1] = row.g[q][-1];
        row.kept[q][nx] = row.g[q][nx];
      }
    }
    return row;
  }

  /// Prefetches what will be read some segments further on: the processor itself predicts too little of so many
  /// streams.
  KOKKOS_FORCEINLINE_FUNCTION void prefetch_ahead(const Row& row, int start) const {
    constexpr int ahead = 6 * segment, line = 64 / sizeof(T);
    VUG_UNROLL
    for (int q = 0; q < Set::Q; ++q) {
      const T* const read = row.g[q] + (Set::c(q, 1) < 0 ? bands.lattice.pitch : 0) + start + ahead;
      for (int x = 0; x < segment; x += line) prefetch_far(read + x);
    }
  }

  /// Conducts a row and calls conducted(x) when the nodes before x are done.
  template <class Conducted>
  KOKKOS_FORCEINLINE_FUNCTION void conduct(const Row& row, const Matter& local, const Conducted& conducted) const {
    const int nx = bands.lattice.nx, pitch = bands.lattice.pitch, first = row.node;
    T before = row.g[1][-1];  // moves to the right, from the node before the segment
    for (int start = 0; start < nx; start += segment) {
      const int n = nx - start < segment ? nx - start : segment;
      prefetch_ahead(row, start);
      alignas(64) T rightward[segment + 1], mask[3][segment + 2];
      rightward[0] = before;
      VUG_VECTORISE
      for (int x = 0; x < n; ++x) rightward[x + 1] = row.g[1][start + x];
      before = rightward[n];
      for (int r = 0; r < 3; ++r) {
        const std::uint8_t* const from = row.kind + (r - 1) * pitch + start - 1;
        VUG_VECTORISE
        for (int x = 0; x < n; ++x) mask[r][x] = local.staged(from[x]);
        for (int x = n; x < n + 2; ++x) mask[r][x] = local.staged(from[x]);
      }
      VUG_VECTORISE
      for (int x = 0; x < n; ++x) {
        const T here = mask[1][x + 1];
        T g[Set::Q], pulled[Set::Q], beyond[Set::Q];
        g[0] = row.g[0][start + x];
        VUG_UNROLL
        for (int q = 1; q < Set::Q; ++q) {
          g[q] = row.g[q][start + x];
          pulled[q] = q == 1 ? rightward[x] : row.pulled[q][start + x];
          beyond[q] = Matter::beyond(mask[1 - Set::c(q, 1)][x + 1 - Set::c(q, 0)], here);
          if (Set::c(q, 1) > 0) row.kept[q][start + x] = g[q];
        }
        if (!Matter::computed(here)) continue;
        local.conduct(first + start + x, g, pulled, row.kind[start + x], here, beyond);
        VUG_UNROLL
        for (int q = 0; q < Set::Q; ++q) row.g[q][start + x] = g[q];
      }
      conducted(start + n);
    }
  }
};

}  // namespace vug
