#pragma once
// Two channels, each over a floor of a mineral of its own, and what acid does there by solutions on paper.
#include "support/coupled_run.hpp"
#include "support/record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace vug::test::mineral_channels {

inline constexpr double dx = 1e-4, dt = 1e-5, D = 2e-4;
inline constexpr int fluid_rows = 10, rock_rows = 12, channel = 4, between = 3;

/// Two channels between inert walls, each over a floor of a mineral of its own; acid comes in from above.
inline const std::string channels = R"(
[lattice]
size = [0.0017, 0.0022]
spacing = 1e-4
time_step = 1e-5
[time]
steps = 1000000
[geometry]
type = "shapes"
background = "solid"
[[geometry.shapes]]
type = "rectangle"
from = [0.0003, 0.0012]
to = [0.0007, 0.0022]
material = "fluid"
[[geometry.shapes]]
type = "rectangle"
from = [0.001, 0.0012]
to = [0.0014, 0.0022]
material = "fluid"
[solute]
[[solute.species]]
name = "acid"
diffusivity = 2e-4
initial = 1000
[reaction]
reactant = "acid"
rate_constant = 0.5
surface_normal = false
[[mineral]]
name = "calcite"
rate_constant = 0.02
molar_volume = 4e-5
[[mineral.shapes]]
type = "rectangle"
from = [0.0003, 0]
to = [0.0007, 0.0012]
[[mineral]]
name = "dolomite"
rate_constant = 0.005
molar_volume = 6.4e-5
stoichiometry = 2
[[mineral.shapes]]
type = "rectangle"
from = [0.001, 0]
to = [0.0014, 0.0012]
[[mineral]]
name = "quartz"
inert = true
[[mineral.shapes]]
type = "rectangle"
from = [0, 0]
to = [0.0003, 0.0022]
[[mineral.shapes]]
type = "rectangle"
from = [0.0007, 0]
to = [0.001, 0.0022]
[[mineral.shapes]]
type = "rectangle"
from = [0.0014, 0]
to = [0.0017, 0.0022]
[boundary.top]
solute = { type = "concentration", concentration = { acid = 1000 } }
)";

/// mol/(m2 s) that a mineral takes in a steady state, by its own account.
inline double flux_into(test::CoupledRun& run, const std::string& mineral, const std::string& reactant,
                        double stoichiometry) {
  const double before = run.gain(mineral + "_dissolved", "by_" + reactant);
  run.steps(200);
  return stoichiometry * (run.gain(mineral + "_dissolved", "by_" + reactant) - before) / (200 * dt * channel * dx);
}

/// Holds the flux against the exact one and keeps both.
inline void expect_flux(const std::string& what, double value, double flux, double exact, double bound) {
  EXPECT_NEAR(flux / exact, 1, bound) << what << " " << value;
  test::record("mineral_flux", {{"what", what}, {"value", value}, {"flux", flux}, {"exact", exact}});
}

/// k C_ref (C/C_ref)^n at the wall = D (C_0 - C)/d, by bisection.
inline double flux_of_order(double k, double n, double C_ref, double C_0, double diffusivity = D) {
  double low = 0, high = C_0;
  for (int i = 0; i < 200; ++i) {
    const double C = 0.5 * (low + high);
    (k * C_ref * std::pow(C / C_ref, n) < diffusivity * (C_0 - C) / (fluid_rows * dx) ? low : high) = C;
  }
  return diffusivity * (C_0 - low) / (fluid_rows * dx);
}

}  // namespace vug::test::mineral_channels
