#pragma once
// Rock of several materials: which numbers a triangle and a bond get.
#include "dem/assembly.hpp"
#include "dem/parameters.hpp"

namespace vug {

/// Material of a triangle.
RockMaterial material_of(const MechanicsParameters& parameters, const Assembly& assembly, int triangle);

/// A bond between two materials whose centroids lie h_a and h_b from the common edge: springs in series,
///   M = (h_a + h_b) / (h_a / M_a + h_b / M_b),
/// of strengths, friction and fracture energies each the smaller one, whichever material it is of, the viscosity's eta
/// weighted with h. Within one material its own numbers, to the bit.
BondParameters joint_of(const BondParameters& a, double h_a, const BondParameters& b, double h_b);

/// Thermal expansion on which those of all materials are counted: the largest.
double largest_expansion(const MechanicsParameters& parameters);

/// Thermal expansion of the rock as a whole: that of its triangles, meant over their areas, 1/K.
double mean_expansion(const MechanicsParameters& parameters, const Assembly& assembly);

/// Least normal strength of all materials, Pa.
double least_normal_strength(const MechanicsParameters& parameters);

/// Time in which sound crosses the rock along the longer side of its bounding box, s: at the slowness of its triangles,
/// meant over their areas, and sqrt(mass_scaling) times slower.
double sound_crossing(const MechanicsParameters& parameters, const Assembly& assembly);

/// Throws InputError where an assembly names a region that has no material.
void require_materials(const MechanicsParameters& parameters, const Assembly& assembly);

}  // namespace vug
