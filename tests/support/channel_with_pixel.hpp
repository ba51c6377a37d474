#pragma once
// A channel with rock that acid takes away, for tests of choices of speed against accuracy.
#include <string>

namespace vug::test {

/// A channel with a block of rock in it, which acid dissolves.
inline const std::string channel_with_pixel = R"(
[lattice]
size = [0.024, 0.009]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0.010, 0]
to = [0.013, 0.004]
[flow]
viscosity = 2e-4
initial_pressure = 0
[solute]
[[solute.species]]
name = "A"
diffusivity = 1e-4
initial = 1000
[reaction]
reactant = "A"
rate_constant = 2e-4
molar_volume = 4e-4
[boundary.left]
flow = { type = "pressure", pressure = 5, ramp_time = 0.5 }
solute = { type = "concentration", concentration = { A = 1000 } }
[boundary.right]
flow = { type = "pressure", pressure = 0 }
solute = { type = "outflow" }
[accuracy]
guard_interval = 20
)";

}  // namespace vug::test
