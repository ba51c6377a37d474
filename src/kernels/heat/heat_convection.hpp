#pragma once
// Convection and temperatures on a host, right behind the conduction of a row: row(y) is what follows it, up_to(end)
// when the nodes of the row before dense node `end` are conducted, and end() after the last of them.
#include "kernels/heat/heat_kernels.hpp"
#include "kernels/launch/launch.hpp"

#include <type_traits>

namespace vug {

/// Eight neighbours at a time: in rock two or three of them are fluid, but what is dense is read and written in whole
/// registers. The others come out as they were: nothing moves there.
template <class T, class Set>
struct ConvectEights {
  Advect<T, Set> advect;
  IndexList index;
  FluidRows rows;
  ScalarField<double> created;

  struct Row {
    const ConvectEights& all;
    Advect<T, Set> local;
    int y, k, last;
    double sum[eight_lanes] = {};

    KOKKOS_FORCEINLINE_FUNCTION void up_to(int end) {
      for (; k < last && all.rows.eights(k).node < end; ++k) {
        const WetEight& eight = all.rows.eights(k);
        if (eight.fluid >= 0) [[likely]]
          convect(local, eight, sum);
        else
          one_by_one(local, all.index, eight, sum);
      }
    }
    KOKKOS_FORCEINLINE_FUNCTION void end() { all.created(y) += sum_of_lanes(sum); }
  };
  KOKKOS_FORCEINLINE_FUNCTION Row row(int y) const { return {*this, advect, y, rows.first(y), rows.first(y + 1)}; }

 private:
  using E = Eight<T>;
  using Lane = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;  // else vectors of half the length

  KOKKOS_FORCEINLINE_FUNCTION static void one_by_one(const Advect<T, Set>& at, const IndexList& index,
                                                     const WetEight& eight, double (&sum)[eight_lanes]) {
    for (int l = 0; l < eight_lanes; ++l)
      if (eight.wet >> l & 1) sum[l] += at(index(eight.node + l));
  }

  KOKKOS_FORCEINLINE_FUNCTION static void convect(const Advect<T, Set>& at, const WetEight& eight,
                                                  double (&sum)[eight_lanes]) {
    alignas(64) T lagged[eight_lanes], ux[eight_lanes], uy[eight_lanes];
    alignas(64) Lane walls[eight_lanes];
    const int fluid = eight.fluid;
    const unsigned listed = (1u << Kokkos::Experimental::popcount_builtin(unsigned(eight.wet))) - 1;
    follow(at, fluid, listed, lagged);
    E::store(lagged, E::spread(eight.wet, E::load(lagged)));
    E::store(ux, E::spread(eight.wet, E::load(&at.u.u(fluid, 0), listed)));
    E::store(uy, E::spread(eight.wet, E::load(&at.u.u(fluid, 1), listed)));
    VUG_VECTORISE
    for (int l = 0; l < eight_lanes; ++l) walls[l] = eight.closed[l];
    T* const g = &at.g(eight.node);
    VUG_VECTORISE
    for (int l = 0; l < eight_lanes; ++l) {
      const T conducted = sum_of_populations<Set, T>(g + l, at.plane);
      const T added = at.law.added(conducted, lagged[l]), temperature = conducted + added;
      T rest = added;
      VUG_UNROLL
      for (int q = 1; q < Set::Q; ++q) {
        const T change = T(Set::w(q)) * at.law.change(q, temperature, added, at.u.steps * ux[l], at.u.steps * uy[l],
                                                      walls[l] >> (q - 1) & 1);
        g[q * at.plane + l] += change;
        rest -= change;
      }
      g[l] += rest;
      sum[l] += static_cast<double>(added);
    }
  }

  /// Lets the defect of the `listed` nodes from `fluid` on lag, which `lagged` then holds.
  KOKKOS_FORCEINLINE_FUNCTION static void follow(const Advect<T, Set>& at, int fluid, unsigned listed,
                                                 T (&lagged)[eight_lanes]) {
    alignas(64) T defect[eight_lanes];
    E::store(lagged, E::load(&at.lagged(fluid), listed));
    E::store(defect, E::load(&at.defect(fluid), listed));
    VUG_VECTORISE
    for (int l = 0; l < eight_lanes; ++l) lagged[l] = at.law.follow(lagged[l], defect[l]);
    E::store(&at.lagged(fluid), listed, E::load(lagged));
  }
};

/// Node by node: what lies scattered is brought together for some of them, so that their law runs on vectors.
template <class T, class Set>
struct ConvectScattered {
  Advect<T, Set> advect;
  FluidRows rows;
  ScalarField<double> created;

  static constexpr int some = 64, lanes = 16;

  /// The state of some nodes and what is added to it.
  struct Staged {
    alignas(64) T theta[some], ux[some], uy[some], lagged[some], defect[some], added[some], rest[some];
    alignas(64) T change[Set::Q][some];
    alignas(64) int node[some], walls[some];
  };

  struct Row {
    const ConvectScattered& all;
    Advect<T, Set> local;
    int y, k, last;
    double sum = 0;
    Staged staged{};

    KOKKOS_FORCEINLINE_FUNCTION void up_to(int end) {
      while (k < last) {
        const int* const fluid = &all.rows.fluid(k);
        const int count = gather(local, fluid, last - k < some ? last - k : some, end, staged);
        if (count == 0) return;
        convect(local.law, (count + lanes - 1) / lanes * lanes, staged);
        sum = scatter(local, fluid, count, staged, sum);
        k += count;
      }
    }
    KOKKOS_FORCEINLINE_FUNCTION void end() { all.created(y) += sum; }
  };
  KOKKOS_FORCEINLINE_FUNCTION Row row(int y) const { return {*this, advect, y, rows.first(y), rows.first(y + 1)}; }

 private:
  /// At most that many, before node `end`; returns how many.
  KOKKOS_FORCEINLINE_FUNCTION static int gather(const Advect<T, Set>& at, const int* fluid, int most, int end,
                                                Staged& s) {
    int k = 0;
    for (; k < most && at.node(fluid[k]) < end; ++k) {
      const int i = fluid[k];
      s.node[k] = at.node(i);
      s.walls[k] = static_cast<int>(at.walls(i));
      s.ux[k] = at.u(i, 0);
      s.uy[k] = at.u(i, 1);
      s.lagged[k] = at.lagged(i);
      s.defect[k] = at.defect(i);
      s.theta[k] = sum_of_populations<Set, T>(&at.g(s.node[k]), at.plane);
    }
    return k;
  }

  /// In whole vectors: what lies behind the last node is an older one's and goes nowhere.
  KOKKOS_FORCEINLINE_FUNCTION static void convect(const Convection<T, Set>& law, int count, Staged& s) {
    VUG_VECTORISE
    for (int k = 0; k < count; ++k) {
      s.lagged[k] = law.follow(s.lagged[k], s.defect[k]);
      s.added[k] = law.added(s.theta[k], s.lagged[k]);
      s.theta[k] += s.added[k];
      T rest = s.added[k];
      VUG_UNROLL
      for (int q = 1; q < Set::Q; ++q) {
        s.change[q][k] = law.change(q, s.theta[k], s.added[k], s.ux[k], s.uy[k], s.walls[k] >> q & 1);
        rest -= T(Set::w(q)) * s.change[q][k];
      }
      s.rest[k] = rest;
    }
  }

  /// Adds what the advective form adds to `sum`, in the order of the nodes.
  KOKKOS_FORCEINLINE_FUNCTION static double scatter(const Advect<T, Set>& at, const int* fluid, int count,
                                                    const Staged& s, double sum) {
    for (int k = 0; k < count; ++k) {
      T* const g = &at.g(s.node[k]);
      g[0] += s.rest[k];
      VUG_UNROLL
      for (int q = 1; q < Set::Q; ++q) g[q * at.plane] += T(Set::w(q)) * s.change[q][k];
      at.lagged(fluid[k]) = s.lagged[k];
      sum += static_cast<double>(s.added[k]);
    }
    return sum;
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

/// What follows in a row, and then the temperatures of what is done, if there is a place for them.
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

/// The form that this host is made for.
template <class Set, class T>
auto convect_rows(const FluidNodes& nodes, const FluidRows& rows, const Advect<T, Set>& advect,
                  const ScalarField<double>& created) {
  if constexpr (has_eight_lanes)
    return ConvectEights<T, Set>{advect, nodes.index, rows, created};
  else
    return ConvectScattered<T, Set>{advect, rows, created};
}

}  // namespace vug
