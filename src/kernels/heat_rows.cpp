// The heat step on a host: conduction and convection of a row while it is in the cache.
#include "kernels/heat_kernels.hpp"
#include "kernels/row_launch.hpp"

#include <utility>

namespace vug {

/// Numbers the fluid nodes in the order of the dense lattice.
struct CollectRows {
  Lattice lattice;
  IndexList index, first, fluid;
  KOKKOS_FUNCTION void operator()(int item, int& running, bool last) const {
    const int x = item % lattice.nx, y = item / lattice.nx, i = index(lattice.node(x, y));
    if (last && x == 0) first(y) = running;
    if (last && i >= 0) fluid(running) = i;
    if (i >= 0) ++running;
    if (last && x == lattice.nx - 1) first(y + 1) = running;
  }
};

FluidRows fluid_rows(const Exec& exec, const FluidNodes& nodes) {
  FluidRows rows;
  if constexpr (runs_on_host) {
    const Lattice& lattice = nodes.lattice;
    rows.first = IndexList("vug::heat::rows_first", lattice.ny + 1);
    rows.fluid = IndexList("vug::heat::rows_fluid", nodes.count);
    int count = 0;
    Kokkos::parallel_scan("vug::heat::collect_rows", Kokkos::RangePolicy<Exec>(exec, 0, lattice.nx * lattice.ny),
                          CollectRows{lattice, nodes.index, rows.first, rows.fluid}, count);
  }
  return rows;
}

/// The convection of up to `most` fluid nodes with consecutive numbers: the arithmetic in one loop that vectorises, then
/// what it adds to nodes that lie apart.
template <class T, class Set>
struct ConvectRun {
  static constexpr int most = 64;
  const Advect<T, Set>& advect;

  /// Sums up the energy added in the order of the nodes.
  KOKKOS_FORCEINLINE_FUNCTION void operator()(int first, int count, double& sum) const {
    T temperature[most], added[most], change[Set::Q][most];
    for (int l = 0; l < count; ++l) temperature[l] = advect.theta(advect.node(first + l));
    VUG_VECTORISE
    for (int l = 0; l < count; ++l) {
      T own[Set::Q], t = temperature[l];
      added[l] = advect.changes(first + l, t, own);
      temperature[l] = t;
      VUG_UNROLL
      for (int q = 0; q < Set::Q; ++q) change[q][l] = own[q];
    }
    for (int l = 0; l < count; ++l) {
      const int n = advect.node(first + l);
      advect.g(n) += change[0][l];
      VUG_UNROLL
      for (int q = 1; q < Set::Q; ++q) advect.g(q * advect.plane + n) += T(Set::w(q)) * change[q][l];
      advect.theta(n) = temperature[l];
      sum += static_cast<double>(added[l]);
    }
  }
};

/// One row: all its nodes conduct, then its fluid nodes convect.
template <class T, class Set, class Conduction>
struct HeatRow {
  detail::RowOfNodes<Conduction> conduct;
  Advect<T, Set> advect;
  FluidRows rows;
  ScalarField<double> created;
  KOKKOS_FUNCTION void operator()(int y) const {
    conduct(y);
    const detail::LocalBody<Advect<T, Set>> copy(advect);
    const ConvectRun<T, Set> convect{copy.body};
    double sum = 0;
    const int last = rows.first(y + 1);
    for (int k = rows.first(y); k < last;) {
      const int first = rows.fluid(k);
      int count = 1;
      while (count < convect.most && k + count < last && rows.fluid(k + count) == first + count) ++count;
      convect(first, count, sum);
      k += count;
    }
    created(y) += sum;
  }
};

template <class T>
void conduct_and_advect(const Exec& exec, const FluidNodes& nodes, const FluidRows& rows, const VectorField<T>& u,
                        const ScalarField<T>& defect, const ScalarField<T>& lagged, HeatFields<T>& fields,
                        const ScalarField<double>& created) {
  if constexpr (runs_on_host) {
    visit_velocity_set(fields.velocity_set, [&](auto set) {
      using Set = decltype(set);
      const auto convection = advect_body<T, Set>(nodes, u, defect, lagged, fields, fields.g_next);
      const auto launch = [&](const auto& conduction) {
        const HeatRow<T, Set, std::decay_t<decltype(conduction)>> row{
            {conduction, fields.lattice}, convection, rows, created};
        Kokkos::parallel_for("vug::heat::rows", Kokkos::RangePolicy<Exec>(exec, 0, fields.lattice.ny), row);
      };
      if (fields.openings)
        launch(conduct_body<T, Set, true>(fields));
      else
        launch(conduct_body<T, Set, false>(fields));
    });
    std::swap(fields.g, fields.g_next);
  } else {
    conduct(exec, fields);
    advect(exec, nodes, u, defect, lagged, fields, created);
  }
}

#define VUG_INSTANTIATE(T)                                                                                        \
  template void conduct_and_advect(const Exec&, const FluidNodes&, const FluidRows&, const VectorField<T>&,       \
                                   const ScalarField<T>&, const ScalarField<T>&, HeatFields<T>&,                  \
                                   const ScalarField<double>&)
VUG_INSTANTIATE(float);
VUG_INSTANTIATE(double);
#undef VUG_INSTANTIATE

}  // namespace vug
