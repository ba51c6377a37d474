#pragma once
// The force of the fluid on the triangles.
#include "coupling/rock_map.hpp"
#include "kernels/momentum_exchange.hpp"

namespace vug {

/// What the fluid does to the particles (paper section 3.1: hydrodynamic force by momentum exchange along the
/// fluid-solid boundary): the wet nodes of each and the links to them, found anew when the surface changes.
class ParticleLoad {
 public:
  /// centroid: (particle, axis), m.
  ParticleLoad(const Lattice& lattice, double spacing, const Groups& nodes_of_particle,
               const VectorField<double>& centroid);
  /// Finds the links of each particle.
  void rebuild(const Exec& exec, const FluidNodes& fluid, const Surface& surface);
  /// Of each particle, about its centroid.
  const WallLinks& links() const { return links_; }

 private:
  double spacing_;
  Groups nodes_of_particle_;
  VectorField<double> centroid_;
  IndexList place_;  ///< (dense node) place in the surface, -1 elsewhere
  Groups wet_;       ///< wet nodes of the particles
  WallLinks links_;
};

}  // namespace vug
