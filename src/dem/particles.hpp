#pragma once
// The rigid triangles: positions, motion, forces from outside.
#include "dem/assembly.hpp"
#include "dem/dissolved_rock.hpp"
#include "dem/parameters.hpp"
#include "dem/triangle.hpp"

namespace vug {

/// Shapes and motion of all particles, SI, 1 m thick. Displacements are stored, not positions, so that micrometres of
/// motion on centimetres of rock keep all their digits. The coupling writes force, torque and temperature_change; the
/// mechanics writes everything else.
struct Particles {
  int count = 0;
  double radius = 0;  ///< of the rounding of all sphero-triangles, m

  VectorField<double> x0;                                   ///< (particle, axis) reference centroid, m
  Kokkos::View<double* [3][2], Kokkos::LayoutLeft> corner;  ///< (particle, corner, axis) body frame, m
  Kokkos::View<double* [3][2], Kokkos::LayoutLeft> eroded;  ///< the same of the eroded triangle, m
  Kokkos::View<int* [3], Kokkos::LayoutLeft> vertex;        ///< (particle, corner) vertex number of the assembly
  ScalarField<double> mass;                                 ///< of the intact particle, kg
  ScalarField<double> inertia;                              ///< of the intact particle about its centroid, kg m2

  VectorField<double> u;                ///< displacement of the centroid since the assembly, m
  VectorField<double> u_reference;      ///< displacement at the end of the preload, m
  VectorField<double> u_origin;         ///< from which output counts u: the same View as u_reference, or zero
  VectorField<double> v;                ///< velocity of the centroid, half a step behind u, m/s
  ScalarField<double> angle;            ///< rotation since the assembly, counter-clockwise
  ScalarField<double> angle_reference;  ///< rotation at the end of the preload
  ScalarField<double> angle_origin;     ///< from which output counts rotations, likewise
  ScalarField<double> spin;             ///< 1/s, half a step behind angle
  VectorField<double> rotation;         ///< (cos(angle) - 1, sin(angle)), kept with angle

  VectorField<double> force;               ///< from outside, written by the coupling, N
  ScalarField<double> torque;              ///< from outside about the moving centroid, N m
  ScalarField<double> solid_fraction;      ///< remaining solid volume over the initial one; see is_gone
  ScalarField<double> temperature_change;  ///< mean of T - T_ref, K
  /// temperature_change times the particle's thermal expansion over MechanicsParameters::thermal_expansion; the same
  /// View where the rock is of one material.
  ScalarField<double> warming;

  /// Bits 1, 2, 4: x, y, spin follow `drive` instead of the forces. Not bytes: a vector holds so many of them that a
  /// loop over particles would not be vectorised, or in far too many registers.
  IndexList held;
  VectorField<double> drive;     ///< (particle, axis) velocity of held axes, m/s
  VectorField<double> reaction;  ///< (particle, axis) force that holds, N; zero on free axes
};

Vec2 vertex_of(const Assembly& assembly, int v);
/// Triangle k of an assembly.
Triangle triangle_of(const Assembly& assembly, int k);

/// Makes particles at rest at the positions of the triangles. Throws InputError for an assembly that is no
/// triangulation.
Particles make_particles(const Assembly& assembly, const MechanicsParameters& parameters);

}  // namespace vug
