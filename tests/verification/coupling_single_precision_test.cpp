// Slow changes of a whole run in single precision: each step adds less than the last place of what it changes.
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

namespace vug {
namespace {

// A closed box of fluid at rest, 1 mol/m3 and, after 1 s of strong heating, 100 K above its reference. Then a step adds
// 5e-7 K and 5e-9 mol/m3 to a row of 20 cells.
const std::string box = R"(
[lattice]
size = [0.02, 0.004]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 200000
[heat]
fluid_diffusivity = 1e-4
solid_diffusivity = 1e-4
fluid_density = 1000
solid_density = 1000
fluid_heat_capacity = 1000
solid_heat_capacity = 1000
initial_temperature = 300
[[solute.species]]
name = "salt"
diffusivity = 1e-4
initial = 1
[boundary.left]
heat = { type = "flux", flux = [[0, 2e6], [0.999, 2e6], [1, 0.5], [1000, 0.5]] }
solute = { type = "flux", flux = { salt = 5e-9 } }
[accuracy]
precision = "single"
)";

TEST(SinglePrecisionOfARun, DeliversSmallFluxes) {
  test::CoupledRun run(box);
  run.steps(5000);  // uniform by then
  const double heat = run.now("heat_stored_J_per_m"), salt = run.now("salt_stored_mol_per_m");
  const int steps = 100000;
  run.steps(steps);
  const double height = 0.004, seconds = steps * 1e-3;
  EXPECT_NEAR(run.now("heat_stored_J_per_m") - heat, 0.5 * height * seconds, 0.05 * 0.5 * height * seconds);
  EXPECT_NEAR(run.now("salt_stored_mol_per_m") - salt, 5e-9 * height * seconds, 0.05 * 5e-9 * height * seconds);
  EXPECT_LT(run.worst_balance(), 1e-6);
}

}  // namespace
}  // namespace vug
