#pragma once
// Forces on the edges of the rock's outline, as the stress of its triangles needs them: each with its lever arm.
#include "dem/loads.hpp"

#include <vector>

namespace vug {

/// (particle, component) Sum of r (x) F over forces F at arms r from the centroid: xx, yy and the symmetric part of xy,
/// N m; then how much of the torque of all forces on the particle belongs to its xy as well.
///
/// A support keeps a triangle from turning, with a couple that is in none of the forces. Across a side with the normal
/// y it is made by forces along y; those along x act at the y of the side, so that sum y F_x is the whole xy:
/// (x F_y + y F_x)/2 less half the torque x F_y - y F_x. At a side with the normal x it is sum x F_y, half more. Where
/// nothing holds a triangle the torque is zero, and so is the share of one that two such sides hold.
using ForceMoments = Kokkos::View<double* [4], Kokkos::LayoutLeft>;

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
  /// A particle that sides with one normal hold.
  struct Kept {
    int particle = 0;
    double share = 0;  ///< of its torque in xy
  };

  std::vector<Loaded> loaded_;
  std::vector<Borne> borne_;
  std::vector<Kept> kept_;
};

}  // namespace vug
