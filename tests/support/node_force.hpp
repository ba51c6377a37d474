#pragma once
// The force of the fluid on every surface node of its own.
#include "kernels/flow/momentum_exchange.hpp"
#include "support/flow_setup.hpp"
#include "support/host_copy.hpp"

namespace vug::test {

/// Force on each node of a surface, lattice units.
template <class T>
class NodeForce {
 public:
  NodeForce(const Flow<T>& flow, const Surface& surface)
      : force_("force", surface.count), torque_("torque", surface.count) {
    const IndexList each("each", surface.count + 1);
    const auto host = Kokkos::create_mirror_view(each);
    for (int s = 0; s <= surface.count; ++s) host(s) = s;
    Kokkos::deep_copy(each, host);
    find_wall_links(flow.exec, flow.nodes, each, surface.node, VectorField<double>("centre", surface.count), 1, links_);
  }
  /// (surface, axis), on the host.
  auto operator()(const Flow<T>& flow) const {
    exchange_momentum(flow.exec, flow.fields, links_, 1, 1, force_, torque_);
    return host_copy(force_);
  }

 private:
  WallLinks links_;
  VectorField<double> force_;
  ScalarField<double> torque_;
};

}  // namespace vug::test
