#pragma once
// The numbers of a case in lattice units.
#include "io/scene.hpp"
#include "io/units.hpp"

#include <string>

namespace vug {

/// A table of the numbers of the case in SI units, with the values that the lattice uses (units: cell, lattice step,
/// density of the fluid, largest concentration), and what one lattice unit of each quantity is. For what changes in
/// time it has the value farthest from zero. Mechanics is left out because it uses SI units.
std::string explain(const Scene& scene, const LatticeUnits& units);

}  // namespace vug
