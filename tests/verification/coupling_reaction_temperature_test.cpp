// Temperature to reaction rate: the flux into a hot wall is that of the Arrhenius rate in series with diffusion.
#include "support/coupled_run.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vug {
namespace {

/// Acid diffuses over 10 cells to a wall that reacts and does not dissolve.
const std::string column = R"(
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
[heat]
fluid_diffusivity = 1.4e-3
solid_diffusivity = 3.5e-3
initial_temperature = 300
[solute]
[[solute.species]]
name = "acid"
diffusivity = 5e-4
initial = 3000
[reaction]
reactant = "acid"
rate_constant = 1.07e-5
activation_energy = 62800
reference_temperature = 273.15
[boundary.left]
solute = { type = "periodic" }
heat = { type = "periodic" }
[boundary.right]
solute = { type = "periodic" }
heat = { type = "periodic" }
[boundary.bottom]
heat = { type = "temperature", temperature = 300 }
[boundary.top]
solute = { type = "concentration", concentration = { acid = 3000 } }
heat = { type = "temperature", temperature = 300 }
)";

TEST(HotWall, ReactsAtTheArrheniusRate) {
  const double gas_constant = 8.31446261815324, diffusivity = 5e-4, depth = 10 * 2.5e-4, inlet = 3000, dt = 1e-5;
  for (const double kelvin : {280.0, 330.0, 380.0, 430.0, 488.15}) {
    const std::string value = std::to_string(kelvin);
    test::CoupledRun run(column, {"heat.initial_temperature=" + value, "boundary.bottom.heat.temperature=" + value,
                                  "boundary.top.heat.temperature=" + value});
    run.steps(8000);  // 8 times the diffusion time
    const double before = run.now("acid_gain_reaction_mol_per_m");
    run.steps(100);
    const double flux = (before - run.now("acid_gain_reaction_mol_per_m")) / (100 * dt * 0.003);
    const double rate = 1.07e-5 * std::exp(62800 / gas_constant * (1 / 273.15 - 1 / kelvin));
    const double exact = inlet / (depth / diffusivity + 1 / rate);
    EXPECT_NEAR(flux / exact, 1, 1e-6) << kelvin;
    test::record("coupling_arrhenius", {{"temperature", kelvin}, {"flux", flux}, {"exact", exact}});
  }
}

}  // namespace
}  // namespace vug
