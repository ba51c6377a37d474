#pragma once
// The density that an outflow prescribes: a level for the whole outflow, by which sound leaves, and a variation along
// its pieces (outflow_pressure.hpp). open_boundary.hpp describes the outflow, open_boundary.cpp applies it.
#include "kernels/flow/open_boundary.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// Adds up, for each outflow, the outward speeds at the nodes of its straight links.
template <class T>
struct OutwardSpeeds {
  using Entry = FlowCondition;
  VectorField<T> u;
  static int count(const FlowCondition& c) { return c.known(); }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run([c, v = u](int link) {
      const int i = c.fluid[link], q = c.direction[link];
      return q < D2Q5::Q ? D2Q9::c(q, 0) * double(v(i, 0)) + D2Q9::c(q, 1) * double(v(i, 1)) : 0;
    });
  }
};

/// Sets rho' = 3 c_s (U - U_0) of each outflow, then U_0 += share (U - U_0), where U is the mean outward speed; clears
/// its sums.
struct SetOutflowLevels {
  using Entry = FlowCondition;
  double share;
  static int count(const FlowCondition& c) { return c.known() > 0 ? 1 : 0; }
  template <class Run>
  KOKKOS_FUNCTION void operator()(const FlowCondition& c, const Run& run) const {
    run([c, kept = share](int) {
      double sum = 0;
      for (int block = 0; block < block_count(c.count); ++block) {
        sum += c.total[block];
        c.total[block] = 0;
      }
      const double change = sum / c.faces - c.level[0];
      c.level[1] = 3 * Kokkos::sqrt(c_s2) * change;
      c.level[0] += kept * change;
    });
  }
};

/// The fluid node that direction q comes from at node i; -1: none.
struct Upstream {
  const int* source;
  int capacity;
  explicit Upstream(const FluidNodes& nodes) : source(nodes.source.data()), capacity(nodes.capacity) {}
  KOKKOS_FORCEINLINE_FUNCTION int operator()(int q, int i) const { return upstream_node(source, capacity, q, i); }
};

/// Direction along a face, towards higher coordinates.
KOKKOS_FORCEINLINE_FUNCTION constexpr int upwards(int face) {
  return D2Q9::c(face, 0) != 0 ? 2 : 1;
}

}  // namespace vug
