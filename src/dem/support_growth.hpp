#pragma once
// Free growth of warm triangles at supports, which hold centroids.
#include "dem/loads.hpp"

namespace vug {

/// Particles that a support holds along the normal of its side, where their centroids lie at different depths behind
/// it.
struct SupportGrowth {
  IndexList particle;
  VectorField<double> depth;    ///< (item, axis) centroid less the mean of all that the side holds, m; 0 on other axes
  ScalarField<double> warming;  ///< (item) Particles::warming for which the particle has been moved, K
};

/// Finds them; none where the rock does not expand.
SupportGrowth find_support_growth(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary,
                                  const Loads& loads, const Particles& particles, double expansion);

/// Moves them along the normal by u = alpha dT (x - mean), as if the rock behind the support grew freely from the mean
/// plane of its centroids. Without this rock that nothing hinders would have stress of E alpha dT times the scatter of
/// these depths over an edge; in rock that is held, the mean plane keeps the stress at E alpha dT.
void grow_at_supports(const Exec& exec, const SupportGrowth& growth, double expansion, const Particles& particles);

}  // namespace vug
