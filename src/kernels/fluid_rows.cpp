#include "kernels/heat.hpp"
#include "kernels/offsets.hpp"

namespace vug {

/// Counts the fluid nodes of a row, into the place behind it.
struct CountRow {
  Lattice lattice;
  IndexList index, first;
  KOKKOS_FUNCTION void operator()(int y) const {
    const int* const row = &index(lattice.node(0, y));
    int count = 0;
    for (int x = 0; x < lattice.nx; ++x) count += row[x] >= 0;
    first(y + 1) = count;
  }
};

/// Lists the fluid nodes of a row.
struct ListRow {
  Lattice lattice;
  IndexList index, first, fluid;
  KOKKOS_FUNCTION void operator()(int y) const {
    const int* const row = &index(lattice.node(0, y));
    int k = first(y);
    for (int x = 0; x < lattice.nx; ++x)
      if (row[x] >= 0) fluid(k++) = row[x];
  }
};

FluidRows fluid_rows(const Exec& exec, const FluidNodes& nodes) {
  FluidRows rows;
  if constexpr (runs_on_host) {
    const Lattice& lattice = nodes.lattice;
    rows.first = IndexList("vug::heat::rows_first", lattice.ny + 1);
    rows.fluid = IndexList("vug::heat::rows_fluid", nodes.count);
    const Kokkos::RangePolicy<Exec> all(exec, 0, lattice.ny);
    Kokkos::parallel_for("vug::heat::count_rows", all, CountRow{lattice, nodes.index, rows.first});
    accumulate_counts(exec, "vug::heat::rows_offsets", rows.first);
    Kokkos::parallel_for("vug::heat::list_rows", all, ListRow{lattice, nodes.index, rows.first, rows.fluid});
  }
  return rows;
}

}  // namespace vug
