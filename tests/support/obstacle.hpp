#pragma once
// A disc of rock in a box, for tests of what is said before a case is run.
#include <string>

namespace vug::test {

/// It conducts heat; nothing flows.
inline const std::string heated_disc = R"(
[lattice]
size = [200, 100]
spacing = 1
time_step = 1
[time]
steps = 1000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "disc"
centre = [60, 50]
radius = 30
[heat]
fluid_diffusivity = 0.1
solid_diffusivity = 0.1
)";

/// A stream with two species goes past it as well.
inline const std::string obstacle = heated_disc + R"(
[flow]
viscosity = 0.1
density = 1
initial_pressure = 0
[solute]
[[solute.species]]
name = "A"
diffusivity = 0.1
[[solute.species]]
name = "B"
diffusivity = 0.1
[boundary.left]
flow = { type = "velocity", velocity = [0.01, 0] }
[boundary.right]
flow = { type = "outflow" }
)";

}  // namespace vug::test
