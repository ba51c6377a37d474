#pragma once
// Small flows for the tests: geometry drawn with characters, fields read and written on the host.
#include "kernels/flow/flow.hpp"
#include "kernels/launch/launch.hpp"
#include "kernels/nodes/fluid_nodes.hpp"
#include "support/host_copy.hpp"
#include "support/set_equilibrium.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace vug::test {

/// Node types from rows of '.', fluid, and anything else, solid; the first row is the top.
inline Kokkos::View<NodeType*> draw(const Lattice& lattice, const std::vector<std::string>& rows) {
  Kokkos::View<NodeType*> type("type", lattice.size());
  const auto host = Kokkos::create_mirror_view(type);
  Kokkos::deep_copy(host, NodeType::solid);
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x)
      if (rows[lattice.ny - 1 - y][x] == '.') host(lattice.node(x, y)) = NodeType::fluid;
  Kokkos::deep_copy(type, host);
  return type;
}

/// Node types where solid(x, y) says so.
template <class Solid>
Kokkos::View<NodeType*> shape(const Lattice& lattice, const Solid& solid) {
  Kokkos::View<NodeType*> type("type", lattice.size());
  const auto host = Kokkos::create_mirror_view(type);
  for (int y = 0; y < lattice.ny; ++y)
    for (int x = 0; x < lattice.nx; ++x) host(lattice.node(x, y)) = solid(x, y) ? NodeType::solid : NodeType::fluid;
  Kokkos::deep_copy(type, host);
  return type;
}

/// A flow at rest with everything that a step needs.
template <class T>
struct Flow {
  Exec exec;
  Lattice lattice;
  Kokkos::View<NodeType*> type;
  FluidNodes nodes;
  FlowFields<T> fields;
  FlowStep<T> step;
  ScalarField<double> gain;  ///< (link) of whatever boundary is dressed; enough for the longest list

  Flow(const Lattice& l, const Kokkos::View<NodeType*>& node_types, std::array<bool, 2> periodic,
       Collision collision = Collision::trt, double tau = 0.8)
      : lattice(l),
        type(node_types),
        nodes(make_fluid_nodes(exec, l, node_types, periodic)),
        fields(make_flow_fields<T>(exec, nodes)),
        gain("gain", 6 * (l.nx + l.ny)) {
    step.collision = collision;
    step.rates = relaxation_rates(collision, tau);
    step.limited = ScalarField<double>("limited", block_count(nodes.capacity));
  }
  Flow(int nx, int ny, std::array<bool, 2> periodic, Collision collision = Collision::trt, double tau = 0.8)
      : Flow(Lattice(nx, ny), Kokkos::View<NodeType*>("type", Lattice(nx, ny).size()), periodic, collision, tau) {}

  void sweep() { collide_and_stream(exec, nodes, fields, step); }

  /// Sets density and velocity by (x, y) -> Macroscopic<double> and the populations to equilibrium.
  template <class State>
  void set(const State& state) {
    const auto node = host_copy(nodes.node);
    const ScalarField<T> rho("rho", nodes.capacity);
    const auto density = Kokkos::create_mirror_view(rho);
    const auto u = Kokkos::create_mirror_view(fields.u);
    for (int i = 0; i < nodes.count; ++i) {
      const Macroscopic<double> m = state(lattice.x(node(i)), lattice.y(node(i)));
      density(i) = T(m.rho);
      u(i, 0) = T(m.ux);
      u(i, 1) = T(m.uy);
    }
    Kokkos::deep_copy(rho, density);
    Kokkos::deep_copy(fields.u, u);
    set_equilibrium(exec, nodes, rho, fields);
  }

  /// Moments of the last sweep at fluid node (x, y); throws where there is rock.
  Macroscopic<double> at(int x, int y) const {
    const auto index = on_host(nodes.index);
    const auto rho = on_host(densities(exec, nodes, fields));
    const auto u = on_host(fields.u);
    const int i = index(lattice.node(x, y));
    if (i < 0) throw std::out_of_range("Flow::at: there is rock");
    return {rho(i), u(i, 0), u(i, 1)};
  }

  double mass() const {
    const ScalarField<double> total("mass", block_count(nodes.count));
    add_mass(exec, nodes, fields, total);
    return sum_in_order(total);
  }

  BoundaryLinks side(Side which) const {
    return find_boundary_links(exec, nodes, which, 0, side_length(lattice, which) - 1, D2Q9::Q);
  }
  IndexList mirror(const BoundaryLinks& links) const { return find_mirror_links(exec, nodes, links); }
};

}  // namespace vug::test
