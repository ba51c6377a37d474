#pragma once
// The launchers of launch.hpp for dense fields: on a host, one row per index with an inner loop over x that the
// compiler vectorises; on a GPU, one node per thread.
#include "kernels/base/lattice.hpp"
#include "kernels/launch/launch.hpp"

namespace vug {

namespace detail {

template <class Body>
struct RowOfNodes {
  Body body;
  Lattice lattice;
  KOKKOS_FUNCTION void operator()(int y) const {
    const Body local = body;
    const int first = lattice.node(0, y);
    const int last = lattice.node(lattice.nx, y);
    VUG_VECTORISE
    for (int node = first; node < last; ++node) local(node);
  }
};

template <class Body>
struct NodeOfRows {
  Body body;
  Lattice lattice;
  KOKKOS_FUNCTION auto operator()(int item) const { return body(lattice.node(item % lattice.nx, item / lattice.nx)); }
};

/// Adds up a row in blocks.
template <class Body>
struct RowSum {
  Body body;
  Lattice lattice;
  ScalarField<double> total;
  KOKKOS_FUNCTION void operator()(int y) const {
    const Body local = body;
    const int last = lattice.node(lattice.nx, y);
    double sum = 0;
    for (int node = lattice.node(0, y); node < last; node += nodes_per_block)
      sum += sum_of_block(local, node, node + nodes_per_block < last ? node + nodes_per_block : last);
    total(y) += sum;
  }
};

}  // namespace detail

/// Runs body(node) for every node inside the lattice, `node` in the dense numbering. Iterations must be independent.
template <class Body>
void for_each_dense_node(const Exec& exec, const std::string& label, const Lattice& lattice, const Body& body) {
  if constexpr (runs_on_host) {
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, lattice.ny),
                         detail::RowOfNodes<Body>{body, lattice});
  } else {
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, lattice.nx * lattice.ny),
                         detail::NodeOfRows<Body>{body, lattice});
  }
}

/// Entries that the sums of add_per_dense_row need.
inline int dense_sums(const Lattice& lattice) {
  return runs_on_host ? lattice.ny : block_count(lattice.nx * lattice.ny);
}

/// total(row; on a GPU block) += sum of body(node) over its nodes inside the lattice, as add_per_block.
template <class Body>
void add_per_dense_row(const Exec& exec, const std::string& label, const Lattice& lattice, const Body& body,
                       const ScalarField<double>& total) {
  if constexpr (runs_on_host)
    Kokkos::parallel_for(label, Kokkos::RangePolicy<Exec>(exec, 0, lattice.ny),
                         detail::RowSum<Body>{body, lattice, total});
  else
    add_per_block(exec, label, lattice.nx * lattice.ny, detail::NodeOfRows<Body>{body, lattice}, total);
}

}  // namespace vug
