// The heat step: on a host in place, conduction and convection of a row while it is in the cache; on a GPU with two
// lattices, one after the other.
#include "kernels/heat/heat_bands.hpp"
#include "kernels/heat/heat_convection.hpp"
#include "kernels/launch/row_launch.hpp"

#include <utility>

namespace vug {

namespace {

/// Calls visit(Set{}, matter) with the matter of the nodes.
template <class T, class Visit>
void visit_matter(const HeatFields<T>& fields, const Visit& visit) {
  visit_velocity_set(fields.velocity_set, [&](auto set) {
    using Set = decltype(set);
    if (fields.matter.given())
      visit(set, ManyMinerals<T, Set>(fields));
    else if (fields.openings)
      visit(set, TwoPhases<T, Set, true>(fields));
    else
      visit(set, TwoPhases<T, Set, false>(fields));
  });
}

/// Conduction in place, and what follows it in every row (heat_convection.hpp).
template <class Set, class T, class Matter, class Convection>
void conduct_in_place(const Exec& exec, const HeatFields<T>& fields, const Matter& matter, const Convection& convection,
                      const ScalarField<T>& theta) {
  using Rows = ThenTemperatures<T, Set, Convection>;
  const Rows rows{convection, fields.lattice, fields.g, theta};
  const HeatBands<T, Set> bands(fields);
  const Kokkos::RangePolicy<Exec> all(exec, 0, bands.count);
  Kokkos::parallel_for("vug::heat::set_aside", all, SetAsideBesideBand<T, Set>{bands});
  const ConductBand<T, Set, Matter, Rows> band{bands, matter, rows};
  Kokkos::parallel_for("vug::heat::rows", all, band);
}

/// Runs `body` at the fluid node of an entry.
template <class Body>
struct OfEntry {
  Body body;
  IndexList fluid;
  KOKKOS_FUNCTION double operator()(int entry) const { return body(fluid(entry)); }
};

}  // namespace

template <class T>
void conduct(const Exec& exec, HeatFields<T>& fields, const std::type_identity_t<ScalarField<T>>& theta) {
  visit_matter(fields, [&](auto set, const auto& matter) {
    using Set = decltype(set);
    if constexpr (runs_on_host)
      conduct_in_place<Set>(exec, fields, matter, NoConvection{}, theta);
    else
      for_each_dense_node(exec, "vug::heat::conduct", fields.lattice, Rows{fields.first_row, fields.rows},
                          conduct_body<Set>(fields, matter, fields.g_next));
  });
  if constexpr (!runs_on_host) {
    std::swap(fields.g, fields.g_next);
    if (theta.extent(0) > 0) take_temperatures(exec, fields, theta);
  }
}

template <class T>
void conduct_and_advect(const Exec& exec, const FluidNodes& nodes, const FluidRows& rows,
                        const std::type_identity_t<Displacement<T>>& u, const ScalarField<T>& defect,
                        const ScalarField<T>& lagged, HeatFields<T>& fields, const ScalarField<double>& created,
                        const std::type_identity_t<ScalarField<T>>& theta) {
  if constexpr (runs_on_host) {
    visit_matter(fields, [&](auto set, const auto& matter) {
      using Set = decltype(set);
      const ConvectRows<T, Set> convection{advect_body<T, Set>(nodes, u, defect, lagged, fields), nodes.index, rows,
                                           created};
      conduct_in_place<Set>(exec, fields, matter, convection, theta);
    });
  } else {
    conduct(exec, fields);
    visit_velocity_set(fields.velocity_set, [&](auto set) {
      const auto body = advect_body<T, decltype(set)>(nodes, u, defect, lagged, fields);
      add_per_listed_row(exec, "vug::heat::advect", rows.first, {fields.first_row, fields.rows},
                         OfEntry<std::decay_t<decltype(body)>>{body, rows.fluid}, created);
    });
    if (theta.extent(0) > 0) take_temperatures(exec, fields, theta);
  }
}

VUG_COMPILE_FOR_NUMBERS(conduct)
VUG_COMPILE_FOR_NUMBERS(conduct_and_advect)

}  // namespace vug
