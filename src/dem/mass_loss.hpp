#pragma once
// Rock that dissolves: triangles lose mass and bonds lose stiffness, with the momentum and energy that these held.
#include "dem/bonds.hpp"
#include "dem/elastic_energy.hpp"

namespace vug {

/// Momentum and energy that have gone with the rock that dissolved, per item so that sums have a fixed order.
struct MassLoss {
  VectorField<double> momentum;  ///< (particle, axis) N s per m
  ScalarField<double> kinetic;   ///< (particle) J per m
  ScalarField<double> elastic;   ///< (bond) J per m
};

/// Sums of MassLoss.
struct LostWithRock {
  int triangles = 0;   ///< that are gone
  Vec2 momentum;       ///< N s per m
  double kinetic = 0;  ///< J per m
  double elastic = 0;  ///< J per m
};

MassLoss make_mass_loss(const Particles& particles, const Bonds& bonds);
void reset(const Exec& exec, const MassLoss& loss);

/// Writes the new solid_fraction (particle) and d_c (bond), which take effect in the next step. Velocities and openings
/// do not change, so the lost mass and stiffness take their share of momentum and energy with them. A triangle that is
/// gone from now on stops. Two kernels, for use between steps; `energy` is that of the last step.
void take_mass(const Exec& exec, const ScalarField<double>& solid_fraction, const ScalarField<double>& d_c,
               double mass_scaling, const ElasticEnergy& energy, const MassLoss& loss);

/// Adds everything up; waits for the device.
LostWithRock lost_with_rock(const Particles& particles, const MassLoss& loss);

}  // namespace vug
