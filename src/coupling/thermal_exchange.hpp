#pragma once
// The temperature of the triangles.
#include "coupling/rock_map.hpp"

#include <optional>

namespace vug {

/// change(p) = mean of theta over the nodes of particle p (fluid pathways inside it included) minus `reference`, K.
/// theta: (dense node), deviation from the heat module's reference temperature. Of the particles listed in `only`,
/// where given.
template <class T>
void warm_particles(const Exec& exec, const NodeGroups& nodes_of_particle, const ScalarField<T>& theta,
                    double reference, const ScalarField<double>& change, const std::optional<IndexList>& only = {});

}  // namespace vug
