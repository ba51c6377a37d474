#include "kernels/nodes/fluid_rows.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

/// Calls visit(x) for every pack of a row that contains fluid, x being its first node.
template <class Visit>
KOKKOS_FORCEINLINE_FUNCTION void visit_row(const int* index, int nx, const Visit& visit) {
  for (int x = 0; x < nx; x += pack_size) {
    bool wet = false;
    for (int l = 0; l < pack_size && x + l < nx; ++l) wet = wet || index[x + l] >= 0;
    if (wet) visit(x);
  }
}

/// Stores the number of entries of row y in first(y + 1).
struct CountRow {
  Lattice lattice;
  IndexList index, first;
  KOKKOS_FUNCTION void operator()(int y) const {
    int count = 0;
    visit_row(&index(lattice.node(0, y)), lattice.nx, [&](int) { ++count; });
    first(y + 1) = count;
  }
};

/// Lists the packs of a row.
struct ListPacks {
  FluidNodes nodes;
  FluidRows rows;

  KOKKOS_FUNCTION WetPack pack_at(int x, int y) const {
    WetPack pack{nodes.lattice.node(x, y), -1, 0, {}};
    int next = -1;
    bool in_order = true;
    for (int l = 0; l < pack_size && x + l < nodes.lattice.nx; ++l) {
      const int i = nodes.index(pack.node + l);
      if (i < 0) continue;
      if (pack.wet == 0) pack.fluid = next = i;
      in_order = in_order && i == next++;
      pack.wet = static_cast<std::uint8_t>(pack.wet | 1u << l);
      const unsigned closed = closed_links(nodes.solid_links(i), nodes.side_links(i), nodes.open_links(i));
      for (int q = 1; q <= 8; ++q)
        pack.closed[q - 1] = static_cast<std::uint8_t>(pack.closed[q - 1] | (closed >> q & 1u) << l);
    }
    if (!in_order) pack.fluid = -1;
    return pack;
  }
  KOKKOS_FUNCTION void operator()(int y) const {
    int k = rows.first(y);
    visit_row(&nodes.index(nodes.lattice.node(0, y)), nodes.lattice.nx,
              [&](int x) { rows.packs(k++) = pack_at(x, y); });
  }
};

/// Lists the fluid nodes of all rows, one by one.
struct ListFluid {
  Lattice lattice;
  IndexList index;
  FluidRows rows;
  KOKKOS_FUNCTION void operator()(int place, int& entry, bool final) const {
    const int x = place % lattice.nx, y = place / lattice.nx;
    const int i = index(lattice.node(x, y));
    if (i >= 0) {
      if (final) rows.fluid(entry) = i;
      ++entry;
    }
    if (final && x == lattice.nx - 1) rows.first(y + 1) = entry;
  }
};

FluidRows fluid_rows(const Exec& exec, const FluidNodes& nodes) {
  const Lattice& lattice = nodes.lattice;
  FluidRows rows;
  rows.first = IndexList("vug::heat::rows_first", lattice.ny + 1);
  if constexpr (runs_on_host) {
    const Kokkos::RangePolicy<Exec> all(exec, 0, lattice.ny);
    Kokkos::parallel_for("vug::heat::count_rows", all, CountRow{lattice, nodes.index, rows.first});
    const int entries = accumulate_counts(exec, "vug::heat::rows_offsets", rows.first);
    rows.packs = Kokkos::View<WetPack*>("vug::heat::rows_packs", entries);
    Kokkos::parallel_for("vug::heat::list_rows", all, ListPacks{nodes, rows});
  } else {
    rows.fluid = IndexList("vug::heat::rows_fluid", nodes.count);
    Kokkos::parallel_scan("vug::heat::list_rows", Kokkos::RangePolicy<Exec>(exec, 0, lattice.nx * lattice.ny),
                          ListFluid{lattice, nodes.index, rows});
  }
  return rows;
}

}  // namespace vug
