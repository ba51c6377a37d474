// What the fluid carries in: amount and heat of a plug flow, in mol and J, for any interval of the steps of heat and
// solute.
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

#include <string>

namespace vug {
namespace {

/// 60 x 6 cells between walls that move with the fluid, 0.05 m/s; what comes in on the left does not reach the right.
const std::string plug = R"(
[lattice]
size = [0.060, 0.006]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "open"
[flow]
viscosity = 1e-4
[heat]
fluid_diffusivity = 5e-5
solid_diffusivity = 5e-5
fluid_density = 800
fluid_heat_capacity = 2000
initial_temperature = 300
[solute]
[[solute.species]]
name = "A"
diffusivity = 5e-5
[boundary.left]
flow = { type = "velocity", velocity = [0.05, 0] }
heat = { type = "temperature", temperature = 340 }
solute = { type = "concentration", concentration = { A = 700 } }
[boundary.right]
flow = { type = "velocity", velocity = [0.05, 0] }
heat = { type = "outflow" }
solute = { type = "outflow" }
[boundary.bottom]
flow = { type = "wall", velocity = [0.05, 0] }
[boundary.top]
flow = { type = "wall", velocity = [0.05, 0] }
)";

/// Carried in by the flow after it has become uniform: U C H t, and rho c_p U (T - T_0) H t.
TEST(TransportInSI, FluidCarriesItsConcentrationAndItsHeat) {
  for (const std::string interval : {"1", "3"}) {
    test::CoupledRun run(plug, {"accuracy.solute_interval=" + interval, "accuracy.heat_interval=" + interval});
    run.steps(300);
    const double mol = run.gain("A", "injected"), joule = run.now("heat_stored_J_per_m");
    run.steps(300);
    const double carried = 0.05 * 0.006 * 0.3;  // m3 per m of depth in 0.3 s
    EXPECT_NEAR((run.gain("A", "injected") - mol) / (700 * carried), 1, 2e-4) << interval;
    EXPECT_NEAR((run.now("heat_stored_J_per_m") - joule) / (800 * 2000 * 40 * carried), 1, 2e-3) << interval;
  }
}

}  // namespace
}  // namespace vug
