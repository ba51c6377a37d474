#pragma once
// Whether the triangles resolve cracks, and the lattice the triangles.
#include "coupling/limits.hpp"
#include "dem/mechanics.hpp"
#include "io/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vug {

/// Limits the mean edge of the bonds by the length over which cracks soften, of the material where it is shortest.
/// `spacing` (m) of the lattice: the advice includes a finer lattice where finer triangles need it; 0 without a
/// lattice.
Limit limit_of_edges(const Mechanics& rock, double spacing);

/// Limits the strain of rock of this thermal expansion (1/K) by a change of temperature (K). Thermal strain scales the
/// lever arms of a triangle, and stress by it is off by about this share.
Limit limit_of_thermal_strain(double expansion, double change);

/// Largest thermal strain at which stresses are right: they are off by about as much as strains differ from small ones.
inline constexpr double largest_small_strain = 0.02;

/// Limits the largest of the initial velocities (m/s) as the velocities of platens are (io/rock_inertia.hpp): rock of
/// s times the mass acts as if it were sqrt(s) times as fast.
Limit limit_of_initial_velocities(const MechanicsSection& rock);

/// Remarks on notches of rock that was read from a mesh (io/notch_remarks.hpp). Those for generated rock come from the
/// reader of the case.
std::vector<std::string> remarks_on_notches_of_mesh(const Scene& scene, const Assembly& rock);

/// A remark where the smallest triangle (generated or read) is smaller than an equilateral one with edges of four
/// cells.
std::optional<std::string> remark_on_triangles(const Assembly& rock, double spacing);

}  // namespace vug
