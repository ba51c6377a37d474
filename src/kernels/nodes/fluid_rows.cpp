#include "kernels/nodes/fluid_rows.hpp"

#include "kernels/base/offsets.hpp"

namespace vug {

/// Calls visit(x) for every fluid node of a row; on hosts with eight lanes for the first of every eight with fluid
/// among them.
template <class Visit>
KOKKOS_FORCEINLINE_FUNCTION void visit_row(const int* index, int nx, const Visit& visit) {
  constexpr int some = has_eight_lanes ? eight_lanes : 1;
  for (int x = 0; x < nx; x += some) {
    bool wet = false;
    for (int l = 0; l < some && x + l < nx; ++l) wet = wet || index[x + l] >= 0;
    if (wet) visit(x);
  }
}

/// Counts the entries of a row, into the place behind it.
struct CountRow {
  Lattice lattice;
  IndexList index, first;
  KOKKOS_FUNCTION void operator()(int y) const {
    int count = 0;
    visit_row(&index(lattice.node(0, y)), lattice.nx, [&](int) { ++count; });
    first(y + 1) = count;
  }
};

/// Lists the fluid nodes of a row.
struct ListRow {
  Lattice lattice;
  IndexList index, first, fluid;
  KOKKOS_FUNCTION void operator()(int y) const {
    int k = first(y);
    visit_row(&index(lattice.node(0, y)), lattice.nx, [&](int x) { fluid(k++) = index(lattice.node(x, y)); });
  }
};

/// Lists the eights of a row.
struct ListEights {
  FluidNodes nodes;
  FluidRows rows;

  KOKKOS_FUNCTION WetEight eight_at(int x, int y) const {
    WetEight eight{nodes.lattice.node(x, y), -1, 0, {}};
    int next = -1;
    bool in_order = true;
    for (int l = 0; l < eight_lanes && x + l < nodes.lattice.nx; ++l) {
      const int i = nodes.index(eight.node + l);
      if (i < 0) continue;
      if (eight.wet == 0) eight.fluid = next = i;
      in_order = in_order && i == next++;
      eight.wet = static_cast<std::uint8_t>(eight.wet | 1u << l);
      const unsigned closed = closed_links(nodes.solid_links(i), nodes.side_links(i), nodes.open_links(i));
      eight.closed[l] = static_cast<std::uint8_t>(closed >> 1);
    }
    if (!in_order) eight.fluid = -1;
    return eight;
  }
  KOKKOS_FUNCTION void operator()(int y) const {
    int k = rows.first(y);
    visit_row(&nodes.index(nodes.lattice.node(0, y)), nodes.lattice.nx,
              [&](int x) { rows.eights(k++) = eight_at(x, y); });
  }
};

FluidRows fluid_rows(const Exec& exec, const FluidNodes& nodes) {
  FluidRows rows;
  if constexpr (runs_on_host) {
    const Lattice& lattice = nodes.lattice;
    rows.first = IndexList("vug::heat::rows_first", lattice.ny + 1);
    const Kokkos::RangePolicy<Exec> all(exec, 0, lattice.ny);
    Kokkos::parallel_for("vug::heat::count_rows", all, CountRow{lattice, nodes.index, rows.first});
    const int entries = accumulate_counts(exec, "vug::heat::rows_offsets", rows.first);
    if constexpr (has_eight_lanes) {
      rows.eights = Kokkos::View<WetEight*>("vug::heat::rows_eights", entries);
      Kokkos::parallel_for("vug::heat::list_rows", all, ListEights{nodes, rows});
    } else {
      rows.fluid = IndexList("vug::heat::rows_fluid", entries);
      Kokkos::parallel_for("vug::heat::list_rows", all, ListRow{lattice, nodes.index, rows.first, rows.fluid});
    }
  }
  return rows;
}

}  // namespace vug
