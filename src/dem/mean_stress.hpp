#pragma once
// Stress of a part of the rock from the forces in its bonds.
#include "dem/bonds.hpp"
#include "dem/outer_forces.hpp"

#include <vector>

namespace vug {

/// Components of the Cauchy stress, tension positive, Pa.
struct Stress {
  double xx = 0, xy = 0, yy = 0;
};

/// (particle, xx yy xy) Stress of each triangle, tension positive, Pa: (1/A) sum of arm (x) force over its edges
/// (Weber's formula, arms to the middles of the edges). Forces of broken bonds and those of `outer` (OuterForces;
/// empty: none) are included, those of other contacts and of the fluid are not.
Kokkos::View<double* [3], Kokkos::LayoutLeft> stress_of_triangles(const Exec& exec, const Particles& particles,
                                                                  const Bonds& bonds, const ForceMoments& outer = {});

/// Mean stress of the given particles, weighted with their areas. Sums in a fixed order on the device, which it waits
/// for.
Stress mean_stress(const Exec& exec, const Particles& particles, const Bonds& bonds, const IndexList& members,
                   const ForceMoments& outer = {});
Stress mean_stress(const Particles& particles, const Bonds& bonds, const std::vector<int>& members,
                   const ForceMoments& outer = {});

}  // namespace vug
