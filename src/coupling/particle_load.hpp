#pragma once
// The force of the fluid on the triangles.
#include "coupling/rock_map.hpp"
#include "kernels/fluid_nodes.hpp"

namespace vug {

/// The wet surface nodes of every particle, as places in Surface (paper section 3.1: hydrodynamic force by momentum
/// exchange along the fluid-solid boundary). Rebuilt when the surface changes.
class WetSurface {
 public:
  WetSurface(const Lattice& lattice, const Groups& nodes_of_particle);
  /// Finds the surface nodes of each particle anew.
  void rebuild(const Exec& exec, const Surface& surface);
  const Groups& of_particle() const { return groups_; }

 private:
  Groups nodes_of_particle_;
  IndexList place_;  ///< (dense node) place in the surface, -1 elsewhere
  Groups groups_;
};

/// force(p) = scale * sum of the node forces of particle p, torque(p) about its centroid, N/m and N.
/// node_force: (surface, axis), lattice units; acts at the node centre. centroid: (particle, axis), m.
void load_particles(const Exec& exec, const Lattice& lattice, double spacing, double scale, const Surface& surface,
                    const WetSurface& wet, const VectorField<double>& node_force, const VectorField<double>& centroid,
                    const VectorField<double>& force, const ScalarField<double>& torque);

}  // namespace vug
