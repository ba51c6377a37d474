#pragma once
// The temperature of the triangles.
#include "coupling/rock.hpp"

#include <optional>
#include <vector>

namespace vug {

/// The nodes from which triangles take their temperature.
struct ThermalNodes {
  /// (particle) nodes whose centre is in it. For a triangle without any: the node at its centroid or, where that is in
  /// an opening, the nearest node outside all openings.
  NodeGroups of_particle;
  std::vector<IndexList> in_opening;  ///< (opening) triangles without a node whose centroid is in it
};
ThermalNodes thermal_nodes(const Scene& scene, const Rock& rock, const Lattice& lattice);

/// change(p) = mean of theta over the nodes of particle p (including fluid pathways in it) minus `reference`, K. theta:
/// (dense node), deviation from the heat module's reference temperature. Only for the particles listed in `only`, where
/// given.
template <class T>
void warm_particles(const Exec& exec, const NodeGroups& nodes_of_particle, const ScalarField<T>& theta,
                    double reference, const ScalarField<double>& change, const std::optional<IndexList>& only = {});

/// change(p) = value, K, for the particles in a list.
void warm_particles_to(const Exec& exec, const IndexList& particles, double value, const ScalarField<double>& change);

}  // namespace vug
