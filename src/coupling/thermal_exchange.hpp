#pragma once
// The temperature of the triangles.
#include "coupling/rock.hpp"

#include <optional>
#include <vector>

namespace vug {

/// Where triangles have their temperature from.
struct ThermalNodes {
  /// (particle) The nodes whose centre lies in it; of a triangle without any that at its centroid or, where it lies in
  /// an opening, the nearest outside of all openings.
  NodeGroups of_particle;
  std::vector<IndexList> in_opening;  ///< (opening) triangles without a node whose centroid lies in it
};
ThermalNodes thermal_nodes(const Scene& scene, const Rock& rock, const Lattice& lattice);

/// change(p) = mean of theta over the nodes of particle p (fluid pathways inside it included) minus `reference`, K.
/// theta: (dense node), deviation from the heat module's reference temperature. Of the particles listed in `only`,
/// where given.
template <class T>
void warm_particles(const Exec& exec, const NodeGroups& nodes_of_particle, const ScalarField<T>& theta,
                    double reference, const ScalarField<double>& change, const std::optional<IndexList>& only = {});

/// change(p) = value, K, for the particles of a list.
void warm_particles_to(const Exec& exec, const IndexList& particles, double value, const ScalarField<double>& change);

}  // namespace vug
