// Minerals side by side: each dissolves at its own speed, takes its own amount of acid and keeps its own balance.
#include "support/coupled_run.hpp"
#include "support/record.hpp"
#include "verification/mineral_channels.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

using namespace test::mineral_channels;

struct Slab {
  std::string name;
  double rate, volume_per_acid;
};

/// A wall that recedes by s where acid diffuses to it over d + s: (d s + s^2/2)/D + s/k = V C t in the quasi-steady
/// limit.
double receded(const Slab& slab, double t) {
  const double d = fluid_rows * dx, a = 0.5 / D, b = d / D + 1 / slab.rate, c = -slab.volume_per_acid * 1000 * t;
  return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

TEST(Minerals, SlabsDissolveEachAtItsOwnSpeed) {
  test::CoupledRun run(channels);
  const std::vector<Slab> slabs{{"calcite", 0.02, 4e-5}, {"dolomite", 0.005, 6.4e-5 / 2}};
  for (const int steps : {70000, 40000}) {
    run.steps(steps);
    const double t = run.now("time_s");
    for (const Slab& slab : slabs) {
      const double s = -run.gain(slab.name + "_volume", "dissolved") / (channel * dx), exact = receded(slab, t);
      EXPECT_NEAR(s / exact, 1, 5e-3) << slab.name << " at " << t;
      EXPECT_GT(exact, dx);
      test::record("mineral_slabs", {{"rate", slab.rate}, {"time", t}, {"receded", s}, {"exact", exact}});
    }
  }
  EXPECT_LT(run.worst_balance(), 1e-12);
  EXPECT_EQ(run.gain("quartz_volume", "dissolved"), 0);
}

/// Walls of a mineral that nothing dissolves are no reactive area, whether it is inert or has no rate.
TEST(Minerals, OnlyWallsThatReactAreReactiveArea) {
  test::CoupledRun run(channels);
  EXPECT_NEAR(run.now("reactive_area_m2_per_m"), 2 * channel * dx, 1e-15);
  test::CoupledRun without_rate(channels, {"mineral.1.rate_constant=0"});
  EXPECT_NEAR(without_rate.now("reactive_area_m2_per_m"), channel * dx, 1e-15);
}

TEST(Minerals, InertGrainsDoNotChange) {
  test::CoupledRun run(channels, {"mineral.0.molar_volume=8e-4", "mineral.1.molar_volume=8e-4"});
  run.steps(60000);
  const int nx = run.scene().lattice.nx;
  const std::vector<double> mineral = run.nodes("mineral"), solid = run.nodes("solid_fraction"),
                            dissolved = run.nodes("dissolved_fraction");
  int inert = 0, gone = 0;
  for (std::size_t n = 0; n < mineral.size(); ++n) {
    if (mineral[n] == 3) {
      ++inert;
      EXPECT_EQ(solid[n], 1);
      EXPECT_EQ(dissolved[n], 0);
    }
    gone += mineral[n] == -1 && n / nx < rock_rows;
  }
  EXPECT_EQ(inert, 3 * between * (fluid_rows + rock_rows));
  EXPECT_GT(gone, 4 * channel);
  EXPECT_EQ(run.now("quartz_volume_stored_m3_per_m"), run.now("quartz_volume_initial_m3_per_m"));
  EXPECT_EQ(run.now("quartz_volume_gain_overdrawn_m3_per_m"), 0);
  EXPECT_LT(run.worst_balance(), 1e-12);
}

TEST(Minerals, EachHasItsArrheniusLaw) {
  test::CoupledRun run(
      channels, {"reaction.temperature=350", "reaction.reference_temperature=300", "reaction.activation_energy=20000",
                 "mineral.1.activation_energy=52000", "mineral.0.molar_volume=1e-12", "mineral.1.molar_volume=1e-12"});
  run.steps(8000);
  const auto exact = [](double k0, double activation) {
    const double k = k0 * std::exp(-activation / gas_constant * (1 / 350.0 - 1 / 300.0));
    return 1000 / (fluid_rows * dx / D + 1 / k);
  };
  expect_flux("activation energy, J/mol", 20000, flux_into(run, "calcite", "acid", 1), exact(0.02, 20000), 1e-7);
  expect_flux("activation energy, J/mol", 52000, flux_into(run, "dolomite", "acid", 2), exact(0.005, 52000), 1e-7);
}

TEST(Minerals, EachGivesItsOwnAmountOfProduct) {
  // 2 acid + dolomite = 3 salt, acid + calcite = salt, each to its own equilibrium in a film d:
  // J = k (C1 - C2/K), C1 = 1000 - J d/D, C2 = y J d/D2
  constexpr double D2 = 1e-4, d = fluid_rows * dx;
  std::string text = channels;
  text.insert(text.find("[reaction]"), "[[solute.species]]\nname = \"salt\"\ndiffusivity = 1e-4\n");
  test::CoupledRun run(
      text, {"reaction.product=\"salt\"", "boundary.top.solute.concentration={acid=1000, salt=0}",
             "mineral.0.equilibrium_constant=2", "mineral.1.equilibrium_constant=0.5",
             "mineral.1.product_stoichiometry=3", "mineral.0.molar_volume=1e-12", "mineral.1.molar_volume=1e-12"});
  run.steps(16000);
  const auto exact = [&](double k, double K, double yield) {
    return 1000 * k / (1 + k * d / D + yield * k / K * d / D2);
  };
  const double salt_before = run.gain("salt", "reaction");
  const double calcite = flux_into(run, "calcite", "acid", 1);
  const double of_200_steps = run.gain("salt", "reaction") - salt_before;
  expect_flux("equilibrium constant, yield 1", 2, calcite, exact(0.02, 2, 1), 1e-7);
  expect_flux("equilibrium constant, yield 1.5", 0.5, flux_into(run, "dolomite", "acid", 2), exact(0.005, 0.5, 1.5),
              1e-7);
  const double given = (exact(0.02, 2, 1) + 1.5 * exact(0.005, 0.5, 1.5)) * 200 * dt * channel * dx;
  EXPECT_NEAR(of_200_steps / given, 1, 1e-7);
  EXPECT_LT(run.worst_balance(), 1e-12);
}

TEST(Minerals, OrdersOtherThanOneTakeTheConcentrationAtTheWall) {
  for (const double order : {0.3, 0.5, 0.8, 1.7, 2.0}) {
    test::CoupledRun run(channels, {fmt::format("mineral.1.order={}", order), "mineral.1.rate_constant=0.3",
                                    "reaction.reference_concentration=400", "mineral.0.molar_volume=1e-12",
                                    "mineral.1.molar_volume=1e-12"});
    run.steps(8000);
    expect_flux("order", order, flux_into(run, "dolomite", "acid", 2), flux_of_order(0.3, order, 400, 1000), 1e-7);
    EXPECT_NEAR(flux_into(run, "calcite", "acid", 1) / flux_of_order(0.02, 1, 400, 1000), 1, 1e-7) << order;
  }
}

/// Rock of one kind needs no minerals for another order.
TEST(Minerals, OrderOfRockWithoutMinerals) {
  const std::string floor = R"(
[lattice]
size = [0.0006, 0.0016]
spacing = 1e-4
time_step = 1e-5
[time]
steps = 1000000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0, 0]
to = [0.0006, 0.0006]
[solute]
[[solute.species]]
name = "acid"
diffusivity = 2e-4
initial = 1000
[reaction]
reactant = "acid"
rate_constant = 0.3
order = 0.6
reference_concentration = 400
[boundary.left]
solute = { type = "periodic" }
[boundary.right]
solute = { type = "periodic" }
[boundary.top]
solute = { type = "concentration", concentration = { acid = 1000 } }
)";
  test::CoupledRun run(floor);
  run.steps(8000);
  const double before = run.gain("acid", "reaction");
  run.steps(200);
  const double flux = (before - run.gain("acid", "reaction")) / (200 * dt * 6 * dx);
  expect_flux("order, rock of one kind", 0.6, flux, flux_of_order(0.3, 0.6, 400, 1000), 1e-7);
}

/// An equilibrium of its own: the product leaves where the acid comes in, three resistances in series.
TEST(Minerals, EachHasItsEquilibrium) {
  const std::string text = channels + "[[solute.species]]\nname = \"salt\"\ndiffusivity = 3e-4\n";
  for (const std::string law : {"kinetic", "paper"}) {
    test::CoupledRun run(
        text, {"reaction.product=\"salt\"", "mineral.1.equilibrium_constant=1.7", "reaction.wall=\"" + law + "\"",
               "mineral.0.molar_volume=1e-12", "mineral.1.molar_volume=1e-12"});
    run.steps(12000);
    const double d = fluid_rows * dx, bound = law == "kinetic" ? 1e-7 : 1e-3;
    EXPECT_NEAR(flux_into(run, "calcite", "acid", 1) / (1000 / (d / D + 1 / 0.02)), 1, bound) << law;
    // two moles of acid become one of salt
    const double exact = 1000 / (d / D + 1 / 0.005 + 0.5 * d / 3e-4 / 1.7),
                 flux = flux_into(run, "dolomite", "acid", 2);
    expect_flux("equilibrium constant, " + law + " wall", 1.7, flux, exact, bound);
  }
}

}  // namespace
}  // namespace vug
