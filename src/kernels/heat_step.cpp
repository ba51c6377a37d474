// The heat step: on a host in place, conduction and convection of a row while it is in the cache; on a GPU with two
// lattices, one after the other.
#include "kernels/heat_bands.hpp"
#include "kernels/row_launch.hpp"

#include <utility>

namespace vug {

/// One row of fluid nodes convects: what lies scattered is brought together for some of them, so that their law runs on
/// vectors.
template <class T, class Set>
struct ConvectRow {
  static constexpr int some = 64, lanes = 16;

  /// The state of some nodes and what is added to it.
  struct Staged {
    alignas(64) T theta[some], ux[some], uy[some], lagged[some], defect[some], added[some], rest[some];
    alignas(64) T change[Set::Q][some];
    alignas(64) int node[some], walls[some];
  };

  Advect<T, Set> advect;
  FluidRows rows;
  ScalarField<double> created;

  KOKKOS_FUNCTION void operator()(int y) const {
    const detail::LocalBody<Advect<T, Set>> copy(advect);
    const Advect<T, Set>& local = copy.body;
    Staged staged{};
    double sum = 0;
    for (int k = rows.first(y), last = rows.first(y + 1); k < last; k += some) {
      const int* const fluid = &rows.fluid(k);
      const int count = last - k < some ? last - k : some;
      gather(local, fluid, count, staged);
      convect(local.law, (count + lanes - 1) / lanes * lanes, staged);
      sum = scatter(local, fluid, count, staged, sum);
    }
    created(y) += sum;
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION static void gather(const Advect<T, Set>& at, const int* fluid, int count, Staged& s) {
    for (int k = 0; k < count; ++k) {
      const int i = fluid[k];
      s.node[k] = at.node(i);
      s.walls[k] = static_cast<int>(at.walls(i));
      s.ux[k] = at.u(i, 0);
      s.uy[k] = at.u(i, 1);
      s.lagged[k] = at.lagged(i);
      s.defect[k] = at.defect(i);
      s.theta[k] = at.theta(s.node[k]);
    }
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
      at.theta(s.node[k]) = s.theta[k];
      at.lagged(fluid[k]) = s.lagged[k];
      sum += static_cast<double>(s.added[k]);
    }
    return sum;
  }
};

/// Where nothing flows.
struct NoConvection {
  KOKKOS_FUNCTION void operator()(int) const {}
};

namespace {

/// visit(Set{}, std::bool_constant<Openings>{}) as the fields have them.
template <class T, class Visit>
void visit_kind(const HeatFields<T>& fields, const Visit& visit) {
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    if (fields.openings)
      visit(set, std::true_type{});
    else
      visit(set, std::false_type{});
  });
}

/// Conduction in place; finish(y) follows when row y is done.
template <class Set, bool Openings, class T, class Finish>
void conduct_in_place(const Exec& exec, const HeatFields<T>& fields, const Finish& finish) {
  const HeatBands<T, Set> bands(fields);
  const Kokkos::RangePolicy<Exec> all(exec, 0, bands.count);
  Kokkos::parallel_for("vug::heat::set_aside", all, SetAsideBesideBand<T, Set>{bands});
  const ConductBand<T, Set, Openings, Finish> band{bands, Conduction<T, Set>(fields.rates), fields.solid, fields.theta,
                                                   finish};
  Kokkos::parallel_for("vug::heat::rows", all, band);
}

}  // namespace

template <class T>
void conduct(const Exec& exec, HeatFields<T>& fields) {
  visit_kind(fields, [&](auto set, auto openings) {
    using Set = decltype(set);
    if constexpr (runs_on_host)
      conduct_in_place<Set, decltype(openings)::value>(exec, fields, NoConvection{});
    else
      for_each_dense_node(exec, "vug::heat::conduct", fields.lattice,
                          conduct_body<T, Set, decltype(openings)::value>(fields, fields.g_next));
  });
  if constexpr (!runs_on_host) std::swap(fields.g, fields.g_next);
}

template <class T>
void advect(const Exec& exec, const FluidNodes& nodes, const std::type_identity_t<Displacement<T>>& u,
            const ScalarField<T>& defect, const ScalarField<T>& lagged, HeatFields<T>& fields,
            const ScalarField<double>& created) {
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    const auto body = advect_body<T, decltype(set)>(nodes, u, defect, lagged, fields);
    if (created.extent(0) > 0)
      add_per_block(exec, "vug::heat::advect", nodes.count, body, created);
    else
      for_each_node(exec, "vug::heat::advect", nodes.count, body);
  });
}

template <class T>
void conduct_and_advect(const Exec& exec, const FluidNodes& nodes, const FluidRows& rows,
                        const std::type_identity_t<Displacement<T>>& u, const ScalarField<T>& defect,
                        const ScalarField<T>& lagged, HeatFields<T>& fields, const ScalarField<double>& created) {
  if constexpr (runs_on_host) {
    visit_kind(fields, [&](auto set, auto openings) {
      using Set = decltype(set);
      const ConvectRow<T, Set> convection{advect_body<T, Set>(nodes, u, defect, lagged, fields), rows, created};
      conduct_in_place<Set, decltype(openings)::value>(exec, fields, convection);
    });
  } else {
    conduct(exec, fields);
    advect(exec, nodes, u, defect, lagged, fields, created);
  }
}

#define VUG_INSTANTIATE(T)                                                                                   \
  template void conduct(const Exec&, HeatFields<T>&);                                                        \
  template void advect(const Exec&, const FluidNodes&, const Displacement<T>&, const ScalarField<T>&,        \
                       const ScalarField<T>&, HeatFields<T>&, const ScalarField<double>&);                   \
  template void conduct_and_advect(const Exec&, const FluidNodes&, const FluidRows&, const Displacement<T>&, \
                                   const ScalarField<T>&, const ScalarField<T>&, HeatFields<T>&,             \
                                   const ScalarField<double>&)
VUG_INSTANTIATE(float);
VUG_INSTANTIATE(double);
#undef VUG_INSTANTIATE

}  // namespace vug
