#pragma once
// A column of acid over rock, as a case.
#include <string>

namespace vug::test {

/// Ten cells of fluid on six of rock; acid comes in from above.
inline const std::string acid_column = R"(
[lattice]
size = [0.003, 0.004]
spacing = 2.5e-4
time_step = 1e-5
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0, 0]
to = [0.003, 0.0015]
[solute]
[[solute.species]]
name = "acid"
diffusivity = 5e-4
initial = 2000
[reaction]
reactant = "acid"
rate_constant = 0.3
[boundary.left]
solute = { type = "periodic" }
[boundary.right]
solute = { type = "periodic" }
[boundary.top]
solute = { type = "concentration", concentration = { acid = 2500 } }
)";

}  // namespace vug::test
