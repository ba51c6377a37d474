#pragma once
// A block of rock that acid dissolves from a hole, as text of a case.
#include <string>

namespace vug::test {

/// A hole full of acid in a block that stands still.
inline const std::string pickled_rock = R"(
[lattice]
size = [0.02, 0.014]
spacing = 2.5e-4
time_step = 2.5e-6
[time]
steps = 2000
[geometry]
type = "rock"
[rock]
element_size = 3e-3
porosity = 0
[rock.hole]
from = [0, 0.004]
to = [0.006, 0.010]
[solute]
[[solute.species]]
name = "acid"
diffusivity = 5e-4
initial = 3000
[reaction]
reactant = "acid"
rate_constant = 5
molar_volume = 4e-4
[mechanics]
[damage]
[accuracy]
update_interval = 1  # mass and damage are of this step
[boundary.injection]
side = "left"
centre = 0.007
width = 0.006
solute = { type = "concentration", concentration = { acid = 3000 } }
)";

/// `text` with its first `from` as `to`.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

}  // namespace vug::test
