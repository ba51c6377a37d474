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

/// One row: all its nodes conduct, then its fluid nodes convect.
template <class Conduction, class Convection>
struct HeatRow {
  detail::RowOfNodes<Conduction> conduct;
  Convection advect;
  FluidRows rows;
  ScalarField<double> created;
  KOKKOS_FUNCTION void operator()(int y) const {
    conduct(y);
    const detail::LocalBody<Convection> copy(advect);
    const Convection& local = copy.body;
    double sum = 0;
    for (int k = rows.first(y); k < rows.first(y + 1); ++k) sum += local(rows.fluid(k));
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
        const HeatRow<std::decay_t<decltype(conduction)>, Advect<T, Set>> row{
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
