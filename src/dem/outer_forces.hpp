#pragma once
// Forces on the edges of the rock's outline, as the stress of its triangles needs them: each with its lever arm.
#include "dem/loads.hpp"

#include <vector>

namespace vug {

/// (particle, xx yy xy) Sum of r (x) F over forces F at arms r from the centroid, its symmetric part, N m.
using ForceMoments = Kokkos::View<double* [3], Kokkos::LayoutLeft>;

/// What acts on the four sides of the rock, piece by piece. Bearings at a point (SidePart) stand at centroids, without
/// a lever arm.
class OuterForces {
 public:
  OuterForces(const Assembly& assembly, const std::vector<BoundaryEdge>& boundary, const Loads& loads,
              const Particles& particles);

  /// Moments at `time` of stresses, of the rock beyond the sides, and of the supports that hold the particles now: each
  /// acts at the middle of its piece of an edge. Zero for rock that is gone. Computed on the host.
  ForceMoments moments(const Particles& particles, double time) const;

 private:
  /// A piece with its dead load or spring.
  struct Loaded {
    LoadedPiece piece;
    std::array<OverTime, 2> traction;  ///< Pa
    double stiffness = 0;              ///< N/m along the normal
  };
  /// A particle that a support holds along an axis.
  struct Borne {
    int particle = 0, axis = 0;
    Vec2 arm;  ///< to the middle of the edges that bear it
  };

  std::vector<Loaded> loaded_;
  std::vector<Borne> borne_;
};

}  // namespace vug
