#pragma once
// "Your number -> lattice number": what the numbers of a case become on its lattice.
#include "io/scene.hpp"
#include "kernels/base/units.hpp"

#include <string>

namespace vug {

/// A table of the case's own numbers in SI beside what the lattice computes with (cells, lattice steps, the density of
/// the fluid and the largest concentration as units), and what one lattice unit of each quantity is. Of what changes in
/// time the value furthest from zero. Mechanics is not in it: it computes in SI.
std::string explain(const Scene& scene, const LatticeUnits& units);

}  // namespace vug
