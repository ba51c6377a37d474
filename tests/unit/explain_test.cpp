// What numbers of a case become on its lattice, by hand.
#include "coupling/explain.hpp"

#include "coupling/build_modules.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace vug {
namespace {

/// The number on the lattice in the row of a key.
double on_lattice(const std::string& table, const std::string& key) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(key + " ")) continue;
    std::istringstream words(line.substr(key.size()));
    double si = 0, lattice = 0;
    std::string unit;
    words >> si >> unit >> lattice;
    return lattice;
  }
  ADD_FAILURE() << key << " is not in\n" << table;
  return 0;
}

TEST(Explain, GivesEachNumberInCellsAndSteps) {
  const Scene scene = parse_scene(R"(
[lattice]
size = [8e-3, 4e-3]
spacing = 2e-4
time_step = 1e-3
[time]
end = 1.0
[flow]
density = 800
viscosity = 4e-6
body_force = [0.02, 0]
[heat]
initial_temperature = 300
fluid_diffusivity = 2e-7
solid_diffusivity = 1e-6
[solute]
[[solute.species]]
name = "acid"
diffusivity = 1e-6
[boundary.left]
flow = { type = "velocity", velocity = [0.01, 0] }
heat = { type = "temperature", temperature = 290 }
solute = { type = "concentration", concentration = { acid = 50 } }
[boundary.right]
flow = { type = "pressure", pressure = 100032 }
heat = { type = "outflow" }
solute = { type = "outflow" }
)",
                                  "case.toml");
  const std::string table = explain(scene, units_of(scene));
  // a cell is 2e-4 m, a step 1e-3 s: 0.2 m/s, 4e-5 m2/s, 200 m/s2, 800 (0.2)^2 = 32 Pa; the largest concentration is 1
  for (const auto& [key, expected] : {std::pair{"lattice.spacing", 1.0},
                                      {"lattice.time_step", 1.0},
                                      {"flow.density", 1.0},
                                      {"flow.viscosity", 0.1},
                                      {"flow.body_force, along x", 1e-4},
                                      {"heat.initial_temperature", 0.0},
                                      {"thermal diffusivity of the fluid", 0.005},
                                      {"thermal diffusivity of the rock", 0.025},
                                      {"diffusivity of acid", 0.025},
                                      {"boundary.left.flow.velocity", 0.05},
                                      {"boundary.left.heat.temperature", -10.0},
                                      {"boundary.left.solute.concentration.acid", 1.0},
                                      {"boundary.right.flow.pressure", 1.0}})
    EXPECT_NEAR(on_lattice(table, key), expected, 1e-4 * std::abs(expected)) << key << "\n" << table;
}

/// A scaled flow is driven by S times less, whatever drives it.
TEST(Explain, DividesTheBodyForceByThePressureScale) {
  const Scene scene = parse_scene(
      "[lattice]\nsize = [8e-3, 4e-3]\nspacing = 2e-4\ntime_step = 1e-3\n[time]\nend = 1.0\n"
      "[flow]\nviscosity = 4e-6\nbody_force = [0.02, 0]\npressure_scale = 25\n",
      "case.toml");
  EXPECT_NEAR(on_lattice(explain(scene, units_of(scene)), "flow.body_force, along x"), 4e-6, 4e-10);
}

TEST(Explain, TellsPressuresApartThatDifferByATenthOfAPascal) {
  const Scene scene = parse_scene(
      "[lattice]\nsize = [8e-3, 4e-3]\nspacing = 2e-4\ntime_step = 1e-3\n[time]\nend = 1\n[flow]\nviscosity = 4e-6\n"
      "[boundary.left]\nflow = { type = \"pressure\", pressure = 100000.1 }\n",
      "a.toml", {});
  const std::string table = explain(scene, units_of(scene));
  EXPECT_NE(table.find(" 100000.1 Pa "), std::string::npos) << table;
}

}  // namespace
}  // namespace vug
