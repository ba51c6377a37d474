// Heat as a case gives it, in SI.
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

#include <string>

namespace vug {
namespace {

constexpr double dx = 2e-3, dt = 0.05;

/// 16 x 10 cells, the left six of them rock.
const std::string half_rock = R"(
[lattice]
size = [0.032, 0.020]
spacing = 2e-3
time_step = 0.05
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0, 0]
to = [0.012, 0.020]
[heat]
fluid_diffusivity = 1.5e-5
solid_diffusivity = 4e-5
fluid_density = 900
fluid_heat_capacity = 3500
solid_density = 2600
solid_heat_capacity = 850
initial_temperature = 350
)";

/// 20 W/cm2 into the rock for 20 s, 3 W/cm2 out of the fluid through a part of its side.
TEST(HeatInSI, FluxIsInWattsAndHeatInJoules) {
  const std::string sides = R"(
[boundary.left]
heat = { type = "flux", flux = 2e5 }
[boundary.injection]
side = "right"
centre = 0.010
width = 0.012
heat = { type = "flux", flux = -3e4 }
)";
  for (const std::string set : {"d2q5", "d2q9"})
    for (const std::string interval : {"1", "2"}) {
      test::CoupledRun run(half_rock + sides, {"heat.velocity_set=" + set, "accuracy.heat_interval=" + interval});
      const int steps = 400;
      run.steps(steps);
      const double in = 2e5 * 0.020 * steps * dt, out = 3e4 * 0.012 * steps * dt;  // J/m
      EXPECT_NEAR(run.gain("heat", "sides") / in, 1, 1e-12) << set << interval;
      EXPECT_NEAR(run.gain("heat", "injection") / -out, 1, 1e-12) << set << interval;
      const std::vector<double> temperature = run.nodes("temperature");
      double stored = 0;
      for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 16; ++x)
          stored += (x < 6 ? 2600 * 850.0 : 900 * 3500.0) * (temperature[y * 16 + x] - 350) * dx * dx;
      EXPECT_NEAR(stored / (in - out), 1, 1e-11) << set << interval;
      EXPECT_NEAR((run.now("heat_stored_J_per_m") - run.now("heat_initial_J_per_m")) / (in - out), 1, 1e-11);
    }
}

/// What two injections with names let in is theirs, not the side's.
TEST(HeatInSI, InjectionsWithNamesAreNotSides) {
  const std::string sides = R"(
[boundary.left]
heat = { type = "flux", flux = 2e5 }
[[boundary.injection]]
name = "hot"
side = "right"
centre = 0.006
width = 0.004
heat = { type = "flux", flux = 5e4 }
[[boundary.injection]]
name = "cold"
side = "top"
centre = 0.020
width = 0.012
heat = { type = "flux", flux = -3e4 }
)";
  test::CoupledRun run(half_rock + sides);
  const int steps = 100;
  run.steps(steps);
  EXPECT_NEAR(run.gain("heat", "sides") / (2e5 * 0.020 * steps * dt), 1, 1e-12);
  EXPECT_NEAR(run.gain("heat", "injection") / ((5e4 * 0.004 - 3e4 * 0.012) * steps * dt), 1, 1e-12);
}

/// In a steady state the flux that a held temperature lets in is that through rock and fluid in series.
TEST(HeatInSI, HeldTemperaturesDriveTheFluxOfTheConductivities) {
  const std::string ends =
      "[boundary.left]\nheat = { type = \"temperature\", temperature = 390 }\n"
      "[boundary.right]\nheat = { type = \"temperature\", temperature = 330 }\n";
  test::CoupledRun run(half_rock + ends);
  run.steps(20000);
  const double rock = 2600 * 850 * 4e-5, fluid = 900 * 3500 * 1.5e-5;  // W/(m K)
  const double flux = 60 / (6 * dx / rock + 10 * dx / fluid);
  const std::vector<double> temperature = run.nodes("temperature");
  for (int x = 0; x < 16; ++x) {
    const double at = (x + 0.5) * dx;
    const double exact = 390 - flux * (std::min(at, 6 * dx) / rock + std::max(0.0, at - 6 * dx) / fluid);
    EXPECT_NEAR(temperature[3 * 16 + x], exact, 1e-8) << x;
  }
  EXPECT_NEAR(run.now("largest_temperature_change_K"), 390 - flux * 0.5 * dx / rock - 350, 1e-8);
}

/// Through a side with a heat transfer coefficient h flows h times the difference of temperatures, however often heat
/// is stepped: the resistances 1/h, of the rock and of the fluid are in series.
TEST(HeatInSI, TransferCoefficientIsAResistanceInSeries) {
  const std::string ends =
      "[boundary.left]\nheat = { type = \"convection\", temperature = 390, coefficient = 3000 }\n"
      "[boundary.right]\nheat = { type = \"temperature\", temperature = 330 }\n";
  for (const std::string interval : {"1", "2"}) {
    test::CoupledRun run(half_rock + ends, {"accuracy.heat_interval=" + interval});
    run.steps(20000);
    const double rock = 2600 * 850 * 4e-5, fluid = 900 * 3500 * 1.5e-5;  // W/(m K)
    const double flux = 60 / (1 / 3000.0 + 6 * dx / rock + 10 * dx / fluid);
    const std::vector<double> temperature = run.nodes("temperature");
    EXPECT_NEAR(temperature[3 * 16], 390 - flux * (1 / 3000.0 + 0.5 * dx / rock), 1e-6) << interval;
    EXPECT_NEAR(temperature[3 * 16 + 15], 330 + flux * 0.5 * dx / fluid, 1e-6) << interval;
  }
}

}  // namespace
}  // namespace vug
