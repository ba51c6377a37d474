#include "kernels/flow/link_populations.hpp"

#include "kernels/launch/launch.hpp"

namespace vug {

/// Copies the slot of each link, there or back.
template <class T, bool Back>
struct CopyOutgoing {
  IndexList fluid;
  Kokkos::View<const std::uint8_t*> direction;
  int capacity;
  ScalarField<T> outgoing, f;
  KOKKOS_FUNCTION void operator()(int link) const {
    const int slot = direction(link) * capacity + fluid(link);
    if constexpr (Back)
      f(slot) = outgoing(link);
    else
      outgoing(link) = f(slot);
  }
};

template <class T>
ScalarField<T> outgoing_populations(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                                    const ScalarField<T>& f) {
  const ScalarField<T> outgoing(Kokkos::view_alloc(exec, "vug::link_populations::outgoing"), links.count);
  for_each_node(exec, "vug::link_populations::take", links.count,
                CopyOutgoing<T, false>{links.fluid, links.direction, nodes.capacity, outgoing, f});
  return outgoing;
}

template <class T>
void restore_outgoing(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                      const ScalarField<T>& outgoing, const ScalarField<T>& f) {
  for_each_node(exec, "vug::link_populations::restore", links.count,
                CopyOutgoing<T, true>{links.fluid, links.direction, nodes.capacity, outgoing, f});
}

/// Position, in nodes, of a node with link q out of the fluid. Where the link reaches an opening across a joined side,
/// it is that of the node's image beside the opening.
KOKKOS_FORCEINLINE_FUNCTION Kokkos::Array<int, 2> place_at_link(const DenseNeighbour& around, int node, int q) {
  const Lattice& lattice = around.lattice;
  const int beyond = around.along(node, q);
  if (beyond < 0) return {lattice.x(node), lattice.y(node)};  // out of the lattice, by a side
  return {lattice.x(beyond) - D2Q9::c(q, 0), lattice.y(beyond) - D2Q9::c(q, 1)};
}

/// One component (0: x, 1: y, 2: torque) of the force of a link. The force acts along the link, through its node.
template <class T>
struct ForceOfLink {
  DenseNeighbour around;
  IndexList node, fluid;
  Kokkos::View<const std::uint8_t*> direction;
  int capacity;
  ScalarField<T> outgoing, f;
  double centre_x, centre_y;
  int component;
  KOKKOS_FUNCTION double operator()(int link) const {
    const int i = fluid(link), q = direction(link);
    const double momentum = double(outgoing(link)) + double(f(q * capacity + i));
    const double x = momentum * D2Q9::c(q, 0), y = momentum * D2Q9::c(q, 1);
    if (component < 2) return component == 0 ? x : y;
    const Kokkos::Array<int, 2> place = place_at_link(around, node(i), q);
    return (place[0] + 0.5 - centre_x) * y - (place[1] + 0.5 - centre_y) * x;
  }
};

template <class T>
LinkForce force_on_links(const Exec& exec, const FluidNodes& nodes, const BoundaryLinks& links,
                         const ScalarField<T>& outgoing, const ScalarField<T>& f, std::array<double, 2> centre) {
  const auto sum = [&](int component) {
    return sum_of_list(exec, "vug::link_populations::force", links.count,
                       ForceOfLink<T>{nodes.around(), nodes.node, links.fluid, links.direction, nodes.capacity,
                                      outgoing, f, centre[0], centre[1], component});
  };
  return {sum(0), sum(1), sum(2)};
}

/// The weight of a straight link, or that times C.
template <class T>
struct WeighLink {
  IndexList fluid;
  Kokkos::View<const std::uint8_t*> direction;
  ScalarField<T> C;
  VectorField<T> u;
  bool by_flow, times_C;
  KOKKOS_FUNCTION double operator()(int link) const {
    const int i = fluid(link), q = direction(link);
    if (q >= D2Q5::Q) return 0;
    const double weight =
        by_flow ? Kokkos::abs(D2Q9::c(q, 0) * double(u(i, 0)) + D2Q9::c(q, 1) * double(u(i, 1))) : 1.0;
    return times_C ? weight * double(C(i)) : weight;
  }
};

template <class T>
LinkMean mean_at_links(const Exec& exec, const BoundaryLinks& links, const ScalarField<T>& C, const VectorField<T>& u) {
  const auto sum = [&](bool by_flow, bool times_C) {
    return sum_of_list(exec, "vug::link_populations::mean", links.count,
                       WeighLink<T>{links.fluid, links.direction, C, u, by_flow, times_C});
  };
  LinkMean mean{0, 0, sum(false, false), sum(false, true)};
  if (u.extent(0) > 0) mean.flow = sum(true, false), mean.carried = sum(true, true);
  return mean;
}

VUG_COMPILE_FOR_NUMBERS(outgoing_populations)
VUG_COMPILE_FOR_NUMBERS(restore_outgoing)
VUG_COMPILE_FOR_NUMBERS(force_on_links)
VUG_COMPILE_FOR_NUMBERS(mean_at_links)

}  // namespace vug
