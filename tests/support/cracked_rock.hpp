#pragma once
// A rock with one crack through it, for tests of what flows along cracks.
#include <string>

namespace vug::test {

/// Rock of 80 x 41 cells, cracked from the left to the right along the middle of row 20; 1 kPa drives water through.
inline const std::string cracked_rock = R"(
[lattice]
size = [0.02, 0.01025]
spacing = 2.5e-4
time_step = 2.5e-6
[time]
steps = 100000
[geometry]
type = "rock"
[rock]
element_size = 4e-3
porosity = 0
[[rock.notches]]
from = [0, 5.125e-3]
to = [0.02, 5.125e-3]
aperture = 1
[flow]
viscosity = 2.2e-3
initial_pressure = 100e3
[mechanics]
[damage]
pathway_factor = 1e-6
[boundary.left]
flow = { type = "pressure", pressure = 101e3 }
traction = { support = "fixed" }
[boundary.right]
flow = { type = "pressure", pressure = 100e3 }
traction = { support = "fixed" }
)";

}  // namespace vug::test
