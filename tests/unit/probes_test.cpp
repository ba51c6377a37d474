// Probes: which node they read, and what their columns are called.
#include "coupling/run_files.hpp"
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace vug {
namespace {

std::map<std::string, double> probed(const Scene& scene, int steps) {
  Simulation simulation(scene);
  simulation.begin();
  for (int step = 0; step < steps; ++step) simulation.step();
  const FieldList fields = simulation.fields();
  std::vector<HistoryValue> row;
  Probes(scene, fields).add(row);
  std::map<std::string, double> values;
  for (const HistoryValue& value : row) EXPECT_TRUE(values.emplace(value.name, value.value).second) << value.name;
  return values;
}

std::string probe(const std::string& name, double x, double y) {
  return fmt::format("[[output.probes]]\nname = \"{}\"\nat = [{}, {}]\n", name, x, y);
}

/// A single node of rock, column 7 of row 2, is met by points within it, and by none a hair beyond its faces.
TEST(Probes, ReadTheNodeInWhichTheyLie) {
  const auto values =
      probed(parse_scene("[lattice]\nsize = [5.0, 4.0]\nspacing = 0.5\ntime_step = 0.01\n[time]\nsteps = 1\n"
                         "[flow]\nviscosity = 1.0\n[geometry]\ntype = \"shapes\"\n" +
                             test::rectangle(3.5, 1.0, 4.0, 1.5) + probe("low", 3.51, 1.01) +
                             probe("high", 3.99, 1.49) + probe("left", 3.49, 1.25) + probe("right", 4.01, 1.25) +
                             probe("below", 3.75, 0.99) + probe("above", 3.75, 1.51) + probe("corner", 5.0, 4.0),
                         "a.toml"),
             0);
  for (const char* inside : {"low", "high"}) EXPECT_EQ(values.at(inside + std::string("_node_type_1")), 1) << inside;
  for (const char* outside : {"left", "right", "below", "above", "corner"})
    EXPECT_EQ(values.at(outside + std::string("_node_type_1")), 0) << outside;
}

/// 3e-4/1e-4 is less than 3: the point on the boundary lies in the cell above it all the same.
TEST(Probes, OnBoundariesOfCellsReadTheNodeBeyond) {
  const auto values =
      probed(parse_scene("[lattice]\nsize = [1e-3, 4e-4]\nspacing = 1e-4\ntime_step = 1e-4\n[time]\nsteps = 1\n"
                         "[flow]\nviscosity = 1e-5\n[geometry]\ntype = \"shapes\"\n" +
                             test::rectangle(3e-4, 3e-4, 4e-4, 4e-4) + probe("on", 3e-4, 3e-4) +
                             probe("left", 2e-4, 3e-4) + probe("below", 3e-4, 2e-4) + probe("right", 4e-4, 3e-4),
                         "a.toml"),
             0);
  EXPECT_EQ(values.at("on_node_type_1"), 1);
  for (const char* outside : {"left", "below", "right"})
    EXPECT_EQ(values.at(outside + std::string("_node_type_1")), 0) << outside;
}

/// A fluid that nothing holds falls: u = a t in both directions.
TEST(Probes, WriteBothComponentsOfTheVelocity) {
  std::string periodic;
  for (const char* side : {"left", "right", "bottom", "top"})
    periodic += fmt::format("[boundary.{}.flow]\ntype = \"periodic\"\n", side);
  const auto values =
      probed(parse_scene(test::unit_lattice(8, 6) + "[flow]\nviscosity = 0.1\nbody_force = [3e-5, -1e-5]\n" + periodic +
                             probe("p", 2.5, 3.5),
                         "a.toml"),
             100);
  EXPECT_NEAR(values.at("p_velocity_x_m/s"), 3e-3, 0.01 * 3e-3);
  EXPECT_NEAR(values.at("p_velocity_y_m/s"), -1e-3, 0.01 * 1e-3);
}

}  // namespace
}  // namespace vug
