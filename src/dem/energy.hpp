#pragma once
// Energies of the rock at this moment. Sums in a fixed order: the same bits for any number of threads.
#include "dem/bonds.hpp"

namespace vug {

struct Energies {
  double kinetic = 0;  ///< J per m of thickness
  double elastic = 0;  ///< stored in bonds and closed cracks, J per m
};

/// Adds up both; reads two numbers back: not for use inside a step.
Energies measure_energies(const Exec& exec, const MechanicsParameters& parameters, const Particles& particles,
                          const Bonds& bonds);

}  // namespace vug
