#pragma once
// The largest stable time step of the leapfrog.
#include "dem/bonds.hpp"
#include "dem/loads.hpp"

namespace vug {

/// Lower bound of 2 / omega_max for bonds and one contact per particle, s. For springs of elongation e = e_b - e_a
/// between particles a and b, e^2 <= 2 (e_a^2 + e_b^2), so omega_max^2 <= 2 max over particles of the largest
/// eigenvalue of M_i^-1 K_i. K_i (3 × 3: two displacements and the rotation) contains the particle's own ends of its
/// springs: two points per bond, one possible contact at its farthest corner, and the rock beyond a free side. The
/// contact acts along the line to the centroid; a fragment that several pairs press at once, or one off that line, is
/// stiffer than that. Dashpots shorten the step by the factor sqrt(1 + z^2) - z. Uses current masses (dissolution
/// lightens particles) and the stiffness with chemical damage, which cannot heal, but without mechanical damage. Reads
/// back one number: not for use inside a step.
double critical_step(const Exec& exec, const MechanicsParameters& parameters, const Particles& particles,
                     const Bonds& bonds, const BoundaryLoads& loads);

}  // namespace vug
