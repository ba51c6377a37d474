#pragma once
// The launchers of launch.hpp for dense fields: on a host, one row per index with an inner loop over x that the
// compiler vectorises; on a GPU, one node per thread.
#include "kernels/lattice.hpp"
#include "kernels/launch.hpp"

namespace vug {

namespace detail {

template <class Body>
struct RowOfNodes {
  Body body;
  Lattice lattice;
  KOKKOS_FUNCTION void operator()(int y) const {
    const LocalBody<Body> copy(body);
    const Body& local = copy.body;
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
  KOKKOS_FUNCTION void operator()(int item) const { body(lattice.node(item % lattice.nx, item / lattice.nx)); }
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

}  // namespace vug
