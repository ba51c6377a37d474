#include "kernels/flow/face_flow.hpp"

#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"

namespace vug {

/// Computes the excess of one node. Without branches, so that it vectorises on a host: a missing neighbour is replaced
/// by the node itself, with the share 0.
template <class T>
struct FaceExcess {
  Kokkos::View<const T*> f;
  Kokkos::View<const int*> source;
  int capacity;
  T outward;  ///< -1 while populations are turned: those of a link have changed places
  Kokkos::View<const T* [2], Kokkos::LayoutLeft> u;
  VectorField<T> excess;

  struct Neighbour {
    int node;
    T is_fluid;  ///< 1 or 0
  };
  KOKKOS_FORCEINLINE_FUNCTION Neighbour along(int q, int i) const {
    const int node = fluid_neighbour(source, capacity, q, i);
    return {node >= 0 ? node : i, node >= 0 ? T(1) : T(0)};
  }
  /// Net flow along direction q from a node to its neighbour.
  KOKKOS_FORCEINLINE_FUNCTION T through(int q, int node, int neighbour) const {
    return outward * (f(q * capacity + node) - f(D2Q9::opposite(q) * capacity + neighbour));
  }
  /// Share of a diagonal link that passes through this face: half, or all where the corner `other` on the other way
  /// round is rock. None without `one`, an end of the link.
  KOKKOS_FORCEINLINE_FUNCTION static T share(const Neighbour& one, const Neighbour& other) {
    return one.is_fluid * (T(1) - T(0.5) * other.is_fluid);
  }

  KOKKOS_FUNCTION void operator()(int i) const {
    const Neighbour east = along(1, i), north = along(2, i), west = along(3, i), south = along(4, i);
    const Neighbour northeast = along(5, i), northwest = along(6, i), southeast = along(8, i);
    const T to_northeast = through(5, i, northeast.node), between = through(6, east.node, north.node);
    const T to_east = through(1, i, east.node) + share(northeast, north) * to_northeast +
                      share(southeast, south) * through(8, i, southeast.node) - share(north, northeast) * between -
                      share(south, southeast) * through(7, east.node, south.node);
    const T to_north = through(2, i, north.node) + share(northeast, east) * to_northeast +
                       share(northwest, west) * through(6, i, northwest.node) + share(east, northeast) * between -
                       share(west, northwest) * through(7, north.node, west.node);
    excess(i, 0) = east.is_fluid * (T(0.5) * (u(i, 0) + u(east.node, 0)) - to_east);
    excess(i, 1) = north.is_fluid * (T(0.5) * (u(i, 1) + u(north.node, 1)) - to_north);
  }
};

template <class T>
void face_excess(const Exec& exec, const FluidNodes& nodes, const FlowFields<T>& fields, const VectorField<T>& excess) {
  for_each_node(exec, "vug::face_flow::excess", nodes.share(),
                FaceExcess<T>{fields.f, nodes.source, nodes.capacity, T(fields.turned ? -1 : 1), fields.u, excess});
}

VUG_COMPILE_FOR_NUMBERS(face_excess)

}  // namespace vug
