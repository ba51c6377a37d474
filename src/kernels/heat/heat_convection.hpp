#pragma once
// Convection and temperatures on a host, directly after the conduction of a row: row(y) is what follows in row y. Its
// up_to(end) is called when the nodes of the row before dense node `end` are conducted, its end() after the last of
// them.
#include "kernels/heat/heat_kernels.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/launch/prefetch.hpp"

namespace vug {

/// Convection by packs of consecutive nodes. In rock two or three nodes of a pack are fluid, but dense fields are read
/// and written in whole registers. The other nodes stay as they were: nothing moves there.
template <class T, class Set>
struct ConvectRows {
  Advect<T, Set> advect;
  IndexList index;
  FluidRows rows;
  ScalarField<double> created;

  struct Row {
    const ConvectRows& all;
    Advect<T, Set> local;
    int y, k, last;
    double sum[pack_size] = {};

    KOKKOS_FORCEINLINE_FUNCTION void up_to(int end) {
      for (; k < last && all.rows.packs(k).node < end; ++k) {
        const WetPack& pack = all.rows.packs(k);
        announce(local, pack);
        if (pack.fluid >= 0) [[likely]]
          convect(local, pack, sum);
        else
          one_by_one(local, all.index, pack, sum);
      }
    }
    KOKKOS_FORCEINLINE_FUNCTION void end() { all.created(y) += sum_of_lanes(sum); }
  };
  KOKKOS_FORCEINLINE_FUNCTION Row row(int y) const { return {*this, advect, y, rows.first(y), rows.first(y + 1)}; }

 private:
  /// Prefetches later parts of the list and of the fluid's fields: beside the streams of conduction the processor does
  /// not predict these.
  KOKKOS_FORCEINLINE_FUNCTION static void announce(const Advect<T, Set>& at, const WetPack& pack) {
    constexpr int packs_ahead = 16, nodes_ahead = 64;
    prefetch(&pack + packs_ahead);
    const int later = pack.fluid + nodes_ahead;
    prefetch(at.lagged.data() + later);
    prefetch(at.defect.data() + later);
    prefetch(&at.u.u(0, 0) + later);
    prefetch(&at.u.u(0, 1) + later);
  }

  KOKKOS_FORCEINLINE_FUNCTION static void one_by_one(const Advect<T, Set>& at, const IndexList& index,
                                                     const WetPack& pack, double (&sum)[pack_size]) {
    for (int l = 0; l < pack_size; ++l)
      if (pack.wet >> l & 1) sum[l] += at(index(pack.node + l));
  }

  KOKKOS_FORCEINLINE_FUNCTION static void convect(const Advect<T, Set>& at, const WetPack& pack,
                                                  double (&sum)[pack_size]) {
    using P = PackOf<T>;
    const int fluid = pack.fluid;
    const std::uint32_t wet = pack.wet, listed = P::first(wet);
    alignas(64) T lagged[pack_size];
    P::store(lagged, at.law.follow(P::load(&at.lagged(fluid), listed), P::load(&at.defect(fluid), listed)));
    P::store(&at.lagged(fluid), listed, P::load(lagged));
    const Pack<T> ux = at.u.steps * P::spread(wet, &at.u.u(fluid, 0)),
                  uy = at.u.steps * P::spread(wet, &at.u.u(fluid, 1));

    T* const g = &at.g(pack.node);
    Pack<T> conducted = P::load(g);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) conducted += P::load(g + q * at.plane);
    const Pack<T> added = at.law.added(conducted, P::spread(wet, lagged)), temperature = conducted + added;
    RestPopulation<T, Set, Pack<T>> rest(added, added);
    VUG_UNROLL
    for (int q = 1; q < Set::Q; ++q) {
      const Pack<T> carried = P::blend(pack.closed[q - 1], at.law.carried(q, temperature, ux, uy), Pack<T>{});
      const Pack<T> change = T(Set::w(q)) * at.law.change(added, carried);
      const Pack<T> before = P::load(g + q * at.plane), after = before + change;
      P::store(g + q * at.plane, after);
      rest.change(q, before, after, change);
    }
    P::store(g, rest.of_gain(P::load(g), at.rounding, pack.node));
    P::add_to(sum, added);
  }
};

/// Where nothing flows.
struct NoConvection {
  struct Row {
    KOKKOS_FORCEINLINE_FUNCTION void up_to(int) {}
    KOKKOS_FORCEINLINE_FUNCTION void end() {}
  };
  KOKKOS_FORCEINLINE_FUNCTION Row row(int) const { return {}; }
};

/// What follows in a row, and then the temperatures of the nodes that are done, if there is a field for them.
template <class T, class Set, class Rows>
struct ThenTemperatures {
  Rows rows;
  Lattice lattice;
  ScalarField<T> g, theta;

  struct Row {
    typename Rows::Row before;
    const T* g;
    T* theta;
    int plane, node;

    KOKKOS_FORCEINLINE_FUNCTION void up_to(int end) {
      before.up_to(end);
      if (!theta) return;
      VUG_VECTORISE
      for (int n = node; n < end; ++n) theta[n] = sum_of_populations<Set, T>(g + n, plane);
      node = end;
    }
    KOKKOS_FORCEINLINE_FUNCTION void end() { before.end(); }
  };
  KOKKOS_FORCEINLINE_FUNCTION Row row(int y) const {
    return {rows.row(y), g.data(), theta.data(), lattice.size(), lattice.node(0, y)};
  }
};

}  // namespace vug
