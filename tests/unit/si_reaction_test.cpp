// Solutes and their reaction as a case gives them: amounts in mol, rates in m/s, temperatures in K.
#include "support/acid_column.hpp"
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using test::acid_column;

constexpr int nx = 12, rock_rows = 6, fluid_rows = 10;
constexpr double dx = 2.5e-4, dt = 1e-5, width = nx * dx, depth = fluid_rows * dx, gas_constant = 8.31446261815324;

const std::string heat = R"(
[heat]
fluid_diffusivity = 1.4e-3
solid_diffusivity = 5e-3
fluid_density = 950
fluid_heat_capacity = 4200
solid_density = 2600
solid_heat_capacity = 900
initial_temperature = 320
[boundary.bottom.heat]
type = "temperature"
temperature = 420
[boundary.top.heat]
type = "temperature"
temperature = 300
)";

/// mol/(m2 s) that the wall takes from the acid in a steady state.
double flux_into_wall(test::CoupledRun& run, int steps = 8000) {
  run.steps(steps);
  const double before = run.gain("acid", "reaction");
  run.steps(200);
  return (before - run.gain("acid", "reaction")) / (200 * dt * width);
}

double arrhenius_of(double k0, double activation, double kelvin, double reference) {
  return k0 * std::exp(-activation / gas_constant * (1 / kelvin - 1 / reference));
}

/// Film resistance and reaction in series.
double exact_flux(double rate) {
  return 2500 / (depth / 5e-4 + 1 / rate);
}

TEST(ReactionInSI, AWallOfNoRateIsNoReactiveArea) {
  EXPECT_EQ(test::CoupledRun(acid_column, {"reaction.rate_constant=0"}).now("reactive_area_m2_per_m"), 0);
}

TEST(ReactionInSI, RateConstantIsInMetresPerSecond) {
  for (const std::string interval : {"1", "2"}) {
    test::CoupledRun run(acid_column, {"accuracy.solute_interval=" + interval});
    EXPECT_NEAR(flux_into_wall(run) / exact_flux(0.3), 1, 1e-9) << interval;
    EXPECT_NEAR(run.now("reactive_area_m2_per_m"), width, 1e-15);
    const std::vector<double> concentration = run.nodes("concentration_acid");
    for (int y = 0; y < fluid_rows; ++y)
      EXPECT_NEAR(concentration[(rock_rows + y) * nx + 4], 2500 - exact_flux(0.3) * (fluid_rows - y - 0.5) * dx / 5e-4,
                  1e-6)
          << y;
  }
}

TEST(ReactionInSI, DamkohlerNumberIsRateTimesLengthOverDiffusivity) {
  std::string by_number = acid_column;
  by_number.replace(by_number.find("rate_constant = 0.3"), 19, "damkohler = 2.5\nlength = 0.004");
  test::CoupledRun run(by_number);
  EXPECT_NEAR(flux_into_wall(run) / exact_flux(2.5 * 5e-4 / 0.004), 1, 1e-9);
}

TEST(ReactionInSI, WallHasTheTemperatureOfTheCaseWhereThereIsNoHeat) {
  test::CoupledRun run(acid_column, {"reaction.temperature=340", "reaction.activation_energy=41000",
                                     "reaction.reference_temperature=310"});
  EXPECT_NEAR(flux_into_wall(run) / exact_flux(arrhenius_of(0.3, 41000, 340, 310)), 1, 1e-7);
}

/// The face between rock and fluid has the temperature at which both carry the same flux.
TEST(ReactionInSI, HotFaceReactsAtItsOwnTemperature) {
  const double fluid = 950 * 4200 * 1.4e-3 / depth, rock = 2600 * 900 * 5e-3 / (rock_rows * dx);  // W/(m2 K)
  const double face = (rock * 420 + fluid * 300) / (rock + fluid);
  for (const std::string intervals : {"1", "2"}) {
    test::CoupledRun run(acid_column + heat,
                         {"reaction.activation_energy=41000", "reaction.reference_temperature=310",
                          "accuracy.heat_interval=" + intervals, "accuracy.solute_interval=" + intervals});
    EXPECT_NEAR(flux_into_wall(run, 16000) / exact_flux(arrhenius_of(0.3, 41000, face, 310)), 1, 1e-7) << intervals;
  }
}

/// The same where the reaction is so slow that its rate alone counts: nothing hides an error of temperature.
TEST(ReactionInSI, SlowReactionTellsTheTemperatureOfTheFace) {
  const double fluid = 950 * 4200 * 1.4e-3 / depth, rock = 2600 * 900 * 5e-3 / (rock_rows * dx);
  const double face = (rock * 420 + fluid * 300) / (rock + fluid);
  test::CoupledRun run(acid_column + heat, {"reaction.activation_energy=41000", "reaction.reference_temperature=310",
                                            "reaction.rate_constant=1e-6"});
  EXPECT_NEAR(flux_into_wall(run, 16000) / exact_flux(arrhenius_of(1e-6, 41000, face, 310)), 1, 1e-7);
}

/// A + rock = B to an equilibrium, with different diffusivities: three resistances in series.
TEST(ReactionInSI, ProductComesOutAsTheAcidGoesIn) {
  const std::string both = acid_column + "[[solute.species]]\nname = \"salt\"\ndiffusivity = 8e-4\ninitial = 0\n";
  const double flux = 2500 / (depth / 5e-4 + 1 / 0.3 + depth / 8e-4 / 1.7);
  for (const std::string wall : {"kinetic", "paper"}) {
    test::CoupledRun run(
        both, {"reaction.product=\"salt\"", "reaction.equilibrium_constant=1.7", "reaction.wall=\"" + wall + "\""});
    EXPECT_NEAR(flux_into_wall(run, 12000) / flux, 1, wall == "kinetic" ? 1e-8 : 1e-3) << wall;
    const double acid = run.gain("acid", "reaction"), salt = run.gain("salt", "reaction");
    const double out = run.gain("salt", "injected"), in = run.gain("acid", "injected");
    run.steps(200);
    const double turned = flux * 200 * dt * width;  // mol/m
    const double bound = (wall == "kinetic" ? 1e-8 : 1e-3) * turned;
    EXPECT_NEAR(run.gain("acid", "reaction") - acid, -turned, bound) << wall;
    EXPECT_NEAR(run.gain("salt", "reaction") - salt, turned, bound) << wall;
    EXPECT_NEAR(run.gain("acid", "injected") - in, turned, bound) << wall;
    EXPECT_NEAR(run.gain("salt", "injected") - out, -turned, bound) << wall;
  }
}

/// Solid goes with the acid, molar volume by mole, and is missing from the nodes of the surface.
TEST(ReactionInSI, RockLosesItsMolarVolume) {
  const double molar_volume = 3.7e-5;
  test::CoupledRun run(acid_column, {"reaction.molar_volume=3.7e-5"});
  run.steps(2000);
  const double mol = -run.gain("acid", "reaction"), volume = molar_volume * mol;  // per m
  EXPECT_GT(mol, 0);
  EXPECT_NEAR(run.now("dissolved_volume_m3_per_m") / volume, 1, 1e-12);
  EXPECT_NEAR(run.now("solid_volume_initial_m3_per_m"), rock_rows * dx * width, 1e-18);
  EXPECT_NEAR(run.gain("solid_volume", "dissolved") / -volume, 1, 1e-12);
  const std::vector<double> dissolved = run.nodes("dissolved_fraction"), solid = run.nodes("solid_fraction");
  for (int x = 0; x < nx; ++x) {
    EXPECT_NEAR(dissolved[(rock_rows - 1) * nx + x] / (volume / width / dx), 1, 1e-11);
    EXPECT_NEAR(solid[(rock_rows - 1) * nx + x], 1 - volume / width / dx, 1e-12);
    EXPECT_EQ(dissolved[(rock_rows - 2) * nx + x], 0);
    EXPECT_EQ(solid[rock_rows * nx + x], 0);
  }
}

/// A plug of water with 1500 mol/m3 at 0.4 m/s.
TEST(SolutesInSI, PlugBringsWhatItHolds) {
  const std::string plug = R"(
[lattice]
size = [0.003, 0.002]
spacing = 2.5e-4
time_step = 1e-5
[time]
steps = 100000
[geometry]
type = "open"
[flow]
viscosity = 2e-3
[solute]
[[solute.species]]
name = "acid"
diffusivity = 5e-4
initial = 1500
[boundary.left]
flow = { type = "velocity", velocity = [0.4, 0] }
solute = { type = "concentration", concentration = { acid = 1500 } }
[boundary.right]
flow = { type = "velocity", velocity = [0.4, 0] }
solute = { type = "outflow" }
[boundary.bottom]
flow = { type = "periodic" }
solute = { type = "periodic" }
[boundary.top]
flow = { type = "periodic" }
solute = { type = "periodic" }
)";
  for (const std::string interval : {"1", "2"})
    for (const std::string set : {"d2q5", "d2q9"}) {
      test::CoupledRun run(plug, {"accuracy.solute_interval=" + interval, "solute.velocity_set=\"" + set + "\""});
      run.steps(6000);
      const double in = run.gain("acid", "injected"), out = run.gain("acid", "outflow");
      run.steps(200);
      const double carried = 0.4 * 1500 * 0.002 * 200 * dt;  // mol/m
      EXPECT_NEAR((run.gain("acid", "injected") - in) / carried, 1, 1e-11) << interval << set;
      EXPECT_NEAR((run.gain("acid", "outflow") - out) / -carried, 1, 1e-11) << interval << set;
      EXPECT_NEAR(run.now("acid_stored_mol_per_m"), 1500 * 0.003 * 0.002, 1e-9);
    }
}

}  // namespace
}  // namespace vug
