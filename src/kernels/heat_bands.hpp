#pragma once
// Conduction in place, on a host: there a second lattice costs a third of the traffic more, since the cache fetches
// what a store is about to overwrite.
//
// Bands of rows go side by side, each of them upwards row by row. A node pulls old populations from its neighbours;
// what is overwritten before it does is set aside: of the row being done what moves to the right, of the row below
// what moves upwards, in lines that stay in the cache; and before any band begins, of the rows beside it what moves
// into it. All else is still there. Afterwards every population is at its place, and no bit depends on the bands.
#include "kernels/heat_kernels.hpp"
#include "kernels/launch.hpp"

namespace vug {

/// A row with the halo on either side.
template <class T>
KOKKOS_FORCEINLINE_FUNCTION void copy_line(const T* from, T* to, int nx) {
  VUG_VECTORISE
  for (int x = -1; x <= nx; ++x) to[x] = from[x];
}

/// The lines that a band sets aside, rows of the lattice's pitch: two of what moves upwards, in turn of the row below
/// and of the row being done, one of what moves downwards, of the row above the band, one of what moves to the right.
template <class T, class Set>
struct BandLines {
  static constexpr int rising = Set::Q == D2Q9::Q ? 3 : 1;  ///< directions with c_y = 1; as many with -1
  static constexpr int count = 3 * rising + 1;

  /// Number of q among the directions that move up, or among those that move down.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int rank(int q) { return q < 5 ? 0 : 1 + (q + 1) % 2; }

  T* first;  ///< x = 0 of the first line
  int pitch;

  KOKKOS_FORCEINLINE_FUNCTION T* upward(int turn, int q) const { return first + (turn * rising + rank(q)) * pitch; }
  KOKKOS_FORCEINLINE_FUNCTION T* above(int q) const { return first + (2 * rising + rank(q)) * pitch; }
  KOKKOS_FORCEINLINE_FUNCTION T* rightward() const { return first + 3 * rising * pitch; }
};

/// The bands of a lattice and the populations that its conduction in place reads and writes.
template <class T, class Set>
struct HeatBands {
  Lattice lattice;
  int count;
  ScalarField<T> g, lines;

  explicit HeatBands(const HeatFields<T>& fields)
      : lattice(fields.lattice), count(fields.bands), g(fields.g), lines(fields.lines) {}

  /// First row of a band, or the end of the last.
  KOKKOS_FORCEINLINE_FUNCTION int first_row(int band) const {
    return static_cast<int>(static_cast<long long>(band) * lattice.ny / count);
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

/// Conducts a band of rows, calling finish(y) when the populations of row y are those after the step.
template <class T, class Set, bool Openings, class Finish>
struct ConductBand {
  HeatBands<T, Set> bands;
  Conduction<T, Set> law;
  Kokkos::View<const std::uint8_t*> solid;
  ScalarField<T> theta;
  Finish finish;

  KOKKOS_FUNCTION void operator()(int band) const {
    const detail::LocalBody<Conduction<T, Set>> copy(law);
    const BandLines<T, Set> lines = bands.lines_of(band);
    const int first = bands.first_row(band), last = bands.first_row(band + 1) - 1;
    for (int y = first; y <= last; ++y) {
      conduct(y, y == last, (y - first) % 2, lines, copy.body);
      finish(y);
    }
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION void conduct(int y, bool is_last, int turn, const BandLines<T, Set>& lines,
                                           const Conduction<T, Set>& conduction) const {
    const int nx = bands.lattice.nx, pitch = bands.lattice.pitch;
    const std::uint8_t* const mask = &solid(bands.lattice.node(0, y));
    T* const temperature = &theta(bands.lattice.node(0, y));
    T *own[Set::Q], *kept[Set::Q];
    const T* pulled_from[Set::Q];
    own[0] = bands.row(0, y);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      own[q] = bands.row(q, y);
      kept[q] = Set::c(q, 1) > 0 ? lines.upward(1 - turn, q) : nullptr;
      pulled_from[q] = Set::c(q, 1) > 0   ? lines.upward(turn, q)
                       : Set::c(q, 1) < 0 ? (is_last ? lines.above(q) : own[q] + pitch)
                       : Set::c(q, 0) > 0 ? lines.rightward()
                                          : own[q];
      pulled_from[q] -= Set::c(q, 0);
      if (Set::c(q, 1) > 0) {
        kept[q][-1] = own[q][-1];
        kept[q][nx] = own[q][nx];
      }
    }
    copy_line(own[1], lines.rightward(), nx);
    VUG_VECTORISE
    for (int x = 0; x < nx; ++x) {
      const T here = static_cast<T>(mask[x]);
      T node[Set::Q], pulled[Set::Q], beyond[Set::Q];
      node[0] = own[0][x];
      VUG_UNROLL
      for (int q = 1; q < Set::Q; ++q) {
        node[q] = own[q][x];
        pulled[q] = pulled_from[q][x];
        beyond[q] = solid_beyond<T, Set, Openings>(mask[x - Set::c(q, 1) * pitch - Set::c(q, 0)], here);
        if (Set::c(q, 1) > 0) kept[q][x] = node[q];
      }
      if constexpr (Openings)
        if (mask[x] > 1) continue;
      temperature[x] = conduction(node, pulled, here, beyond);
      VUG_UNROLL
      for (int q = 0; q < Set::Q; ++q) own[q][x] = node[q];
    }
  }
};

}  // namespace vug
