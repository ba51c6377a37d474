#pragma once
// The launchers of launch.hpp for dense fields: on a host, one row per index with an inner loop over x that the
// compiler vectorises; on a GPU, one node per thread.
#include "base/lattice.hpp"
#include "kernels/launch/launch.hpp"

namespace vug {

/// Consecutive rows of a lattice.
struct Rows {
  int first, count;
};

namespace detail {

template <class Body>
struct RowOfNodes {
  Body body;
  Lattice lattice;
  KOKKOS_FUNCTION void operator()(int y) const {
    NodeLoop<Body>{body}(lattice.node(0, y), lattice.node(lattice.nx, y));
  }
};

template <class Body>
struct NodeOfRows {
  Body body;
  Lattice lattice;
  int first_row;
  KOKKOS_FUNCTION void operator()(int item) const {
    body(lattice.node(item % lattice.nx, first_row + item / lattice.nx));
  }
};

/// The items of a row: its nodes, or the entries of a list (EntriesOfRow).
struct NodesOfRow {
  Lattice lattice;
  int first_row;
  KOKKOS_FORCEINLINE_FUNCTION int number(int rank) const { return first_row + rank; }
  KOKKOS_FORCEINLINE_FUNCTION int begin(int y) const { return lattice.node(0, y); }
  KOKKOS_FORCEINLINE_FUNCTION int end(int y) const { return lattice.node(lattice.nx, y); }
};
struct EntriesOfRow {
  IndexList first;
  int first_row;
  KOKKOS_FORCEINLINE_FUNCTION int number(int rank) const { return first_row + rank; }
  KOKKOS_FORCEINLINE_FUNCTION int begin(int y) const { return first(y); }
  KOKKOS_FORCEINLINE_FUNCTION int end(int y) const { return first(y + 1); }
};

}  // namespace detail

/// Runs body(node) for every node of `rows`, `node` in the dense numbering. Iterations must be independent.
template <class Body>
void for_each_dense_node(const Exec& exec, const std::string& label, const Lattice& lattice, const Rows& rows,
                         const Body& body) {
  if constexpr (runs_on_host) {
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, rows.first, rows.first + rows.count),
                         detail::RowOfNodes<Body>{body, lattice});
  } else {
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, lattice.nx * rows.count),
                         detail::NodeOfRows<Body>{body, lattice, rows.first});
  }
}

/// The same for every node inside the lattice.
template <class Body>
void for_each_dense_node(const Exec& exec, const std::string& label, const Lattice& lattice, const Body& body) {
  for_each_dense_node(exec, label, lattice, {0, lattice.ny}, body);
}

/// For each of `rows`: total(row) += sum of body(node) over its nodes inside the lattice, as add_per_block. body(node)
/// may also write to the node.
template <class Body>
void add_per_dense_row(const Exec& exec, const std::string& label, const Lattice& lattice, const Rows& rows,
                       const Body& body, const ScalarField<double>& total) {
  detail::add_up(exec, label, rows.count, threads_per_sum,
                 detail::SumOfItems<detail::NodesOfRow, Body>{{lattice, rows.first}, body, total});
}

/// The same over the entries of a list that is ordered by rows. Row y has the entries [first(y), first(y +
/// 1)).
template <class Body>
void add_per_listed_row(const Exec& exec, const std::string& label, const IndexList& first, const Rows& rows,
                        const Body& body, const ScalarField<double>& total) {
  detail::add_up(exec, label, rows.count, threads_per_sum / 2,  // a row of rock has some hundred fluid nodes
                 detail::SumOfItems<detail::EntriesOfRow, Body>{{first, rows.first}, body, total});
}

}  // namespace vug
