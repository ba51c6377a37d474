// Heat as a case gives it: SI in, SI out.
#include "coupling/simulation.hpp"
#include "support/coupled_run.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

/// Water on the left, rock on the right, 20 cells in all; 2000 W/m2 enter on the left, the right is held at 300 K.
const std::string slab = R"(
[lattice]
size = [0.02, 0.003]
spacing = 1e-3
time_step = 0.5
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0.01, 0]
to = [0.02, 0.003]
[heat]
fluid_diffusivity = 4e-7
solid_diffusivity = 8e-7
initial_temperature = 320
[boundary.left]
heat = { type = "flux", flux = "2 kW/m2" }
[boundary.right]
heat = { type = "temperature", temperature = 300 }
[boundary.bottom]
heat = { type = "periodic" }
[boundary.top]
heat = { type = "periodic" }
)";

/// Between two sides as much warmer and colder as the fluid at the start: what is stored is a sum of roundings.
TEST(HeatBalance, HoldsWhereAsMuchLeavesAsEnters) {
  for (const std::string set : {"d2q5", "d2q9"}) {
    test::CoupledRun run(slab, {"heat.velocity_set=" + set, "geometry.type=\"open\"", "geometry.shapes=[]",
                                "boundary.left.heat={ type = \"temperature\", temperature = 340 }"});
    for (int row = 0; row < 20; ++row) {
      run.steps(50);
      EXPECT_LE(run.worst_balance(), 1e-12) << set;
    }
  }
}

TEST(HeatFlux, OfACaseGivesTheGradientOfEachConductivity) {
  const double flux = 2000, water = 4e-7 * 1000 * 4000, rock = 8e-7 * 2500 * 1000;  // W/m2, W/(m K)
  for (const std::string set : {"d2q5", "d2q9"})
    for (const std::string interval : {"1", "2"}) {
      const Scene scene =
          parse_scene(slab, "slab.toml", {"heat.velocity_set=" + set, "accuracy.heat_interval=" + interval});
      Simulation simulation(scene);
      simulation.begin();
      const int steps = 28000;  // 40 times the slowest decay time
      for (int step = 0; step < steps; ++step) simulation.step();
      simulation.guard();
      std::vector<double> temperature(20 * 3);
      for (const Field& field : simulation.fields().lattice)
        if (field.name == "temperature") field.read(temperature);
      for (int x = 0; x < 20; ++x) {
        const double at = (x + 0.5) * 1e-3;
        const double exact = 300 + flux * ((at < 0.01 ? (0.01 - at) / water : 0) + (0.02 - std::max(at, 0.01)) / rock);
        EXPECT_NEAR(temperature[20 + x], exact, 1e-9) << set << ", interval " << interval << ", cell " << x;
      }
      for (const Balance& balance : simulation.ledger().balances)
        // in a steady state the populations are rounded the same way in every step, by half a digit at most
        EXPECT_LE(std::abs(balance.relative_error()), 1.1e-16 * steps) << balance.quantity;
    }
}

/// An outflow along joined sides, and one of a well: wherever the seam is, temperatures are those of elsewhere, moved.
TEST(HeatOutflow, DoesNotKnowWhereSidesAreJoined) {
  constexpr int along = 12, across = 9;
  const auto temperatures = [&](int axis, int moved, const std::string& set) {
    const auto pair = [&](const std::string& a, const std::string& b) {
      return "[" + (axis == 0 ? a + ", " + b : b + ", " + a) + "]";
    };
    const std::array<std::string, 4> sides = axis == 0 ? std::array<std::string, 4>{"left", "right", "bottom", "top"}
                                                       : std::array<std::string, 4>{"bottom", "top", "left", "right"};
    const std::string text = "[lattice]\nsize = " + pair("12", "9") +
                             "\nspacing = 1\ntime_step = 1\n[time]\nsteps = 100\n[geometry]\ntype = \"shapes\"\n"
                             "[[geometry.shapes]]\ntype = \"disc\"\nname = \"well\"\ncentre = " +
                             pair(std::to_string(moved + 2), "5") + "\nradius = 2\n[heat]\nvelocity_set = \"" + set +
                             "\"\nfluid_diffusivity = 0.3\nsolid_diffusivity = 0.3\ninitial_temperature = 300\n"
                             "[boundary]\n" +
                             sides[0] + ".heat.type = \"periodic\"\n" + sides[1] + ".heat.type = \"periodic\"\n" +
                             sides[2] + ".heat = { type = \"temperature\", temperature = 400 }\n" + sides[3] +
                             ".heat.type = \"outflow\"\nshape.well.heat.type = \"outflow\"\n";
    Simulation simulation(parse_scene(text, "case.toml"));
    simulation.begin();
    for (int step = 0; step < 60; ++step) simulation.step();
    std::vector<double> read(along * across), values(along * across);
    for (const Field& field : simulation.fields().lattice)
      if (field.name == "temperature") field.read(read);
    for (int k = 0; k < along; ++k)
      for (int j = 0; j < across; ++j) {
        const int at = (k + moved) % along;
        values[j * along + k] = axis == 0 ? read[j * along + at] : read[at * across + j];
      }
    return values;
  };
  for (const std::string set : {"d2q5", "d2q9"})
    for (const int axis : {0, 1}) {
      const std::vector<double> expected = temperatures(axis, 4, set);
      for (int moved = 0; moved <= along - 4; ++moved)
        EXPECT_EQ(temperatures(axis, moved, set), expected) << set << " along " << axis << " moved by " << moved;
    }
}

TEST(HeatFlux, MayLeaveTheTemperaturesOfTheCaseByMoreThanTheGuardAllowsOthers) {
  const Scene scene = parse_scene(slab, "slab.toml", {"boundary.left.heat.flux=4e5"});
  Simulation simulation(scene);
  simulation.begin();
  for (int step = 0; step < 10000; ++step) simulation.step();
  EXPECT_NO_THROW(simulation.guard());
}

}  // namespace
}  // namespace vug
