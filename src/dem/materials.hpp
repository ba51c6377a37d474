#pragma once
// Rock of several materials: the numbers that a triangle and a bond get.
#include "dem/assembly.hpp"
#include "dem/parameters.hpp"

namespace vug {

/// Material of a triangle.
RockMaterial material_of(const MechanicsParameters& parameters, const Assembly& assembly, int triangle);

/// Parameters of a bond between two materials whose centroids are at the distances h_a and h_b from the common edge:
/// springs in series,
///   M = (h_a + h_b) / (h_a / M_a + h_b / M_b),
/// the smaller one of each strength, friction and fracture energy, whichever material it is of, and the viscosity's eta
/// weighted with h. Within one material they are its own numbers, to the bit.
BondParameters joint_of(const BondParameters& a, double h_a, const BondParameters& b, double h_b);

/// Largest thermal expansion of all materials, 1/K, which serves as the reference of the others.
double largest_expansion(const MechanicsParameters& parameters);

/// Thermal expansion of the rock as a whole, 1/K: mean over the areas of its triangles.
double mean_expansion(const MechanicsParameters& parameters, const Assembly& assembly);

/// Least normal strength of all materials, Pa.
double least_normal_strength(const MechanicsParameters& parameters);

/// Time in which sound crosses the rock along the longer side of its bounding box, s: with the slowness of its
/// triangles, averaged over their areas, and sqrt(mass_scaling) times as long.
double sound_crossing(const MechanicsParameters& parameters, const Assembly& assembly);

/// Throws InputError where an assembly names a region that has no material.
void require_materials(const MechanicsParameters& parameters, const Assembly& assembly);

}  // namespace vug
