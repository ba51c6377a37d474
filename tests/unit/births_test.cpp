// Rock that dissolves where lattices are awkward: at an inlet, at an outlet, in corners, as a lone pixel, around closed
// pores, many pixels at once. All physics must take up the new nodes, and nothing may be lost.
#include "coupling/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace vug {
namespace {

/// 12 x 8 cells of slowly flowing acid with the given rock, everything so fast that it dissolves in some hundred steps.
std::string awkward_rock(const std::string& shapes, const std::string& more) {
  return R"(
[lattice]
size = [0.012, 0.008]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "shapes"
)" + shapes +
         R"(
[flow]
viscosity = 2e-4
initial_pressure = 0
[heat]
fluid_diffusivity = 1e-4
solid_diffusivity = 3e-4
initial_temperature = 350
[solute]
[[solute.species]]
name = "A"
diffusivity = 1e-4
initial = 1000
[[solute.species]]
name = "B"
diffusivity = 1e-4
[reaction]
reactant = "A"
product = "B"
rate_constant = 0.3
molar_volume = 2e-4
[boundary.left]
flow = { type = "pressure", pressure = 5 }
heat = { type = "temperature", temperature = 300 }
solute = { type = "concentration", concentration = { A = 1000 } }
[boundary.right]
flow = { type = "pressure", pressure = 0 }
heat = { type = "outflow" }
solute = { type = "outflow" }
[accuracy]
update_interval = 5
)" + more;
}

std::string rectangle(int x0, int y0, int x1, int y1) {
  const auto at = [](int x, int y) { return "[" + std::to_string(x * 1e-3) + ", " + std::to_string(y * 1e-3) + "]"; };
  return "[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = " + at(x0, y0) + "\nto = " + at(x1, y1) + "\n";
}

/// Steps until all rock is gone; every balance must close at every look.
void dissolve_all(Simulation& simulation, int most_steps) {
  const Geometry& geometry = simulation.parts().geometry;
  const int nodes = geometry.lattice.nx * geometry.lattice.ny;
  simulation.begin();
  for (int step = 1; step <= most_steps && geometry.fluid.count < nodes; ++step) {
    simulation.step();
    if (step % 50 > 0) continue;
    simulation.guard();
    for (const Balance& balance : simulation.ledger().balances)
      ASSERT_LE(std::abs(balance.relative_error()), 1e-12) << balance.quantity << " at step " << step;
  }
  EXPECT_EQ(geometry.fluid.count, nodes);
  EXPECT_EQ(geometry.surface.count, 0);
}

struct Place {
  const char* name;
  std::string shapes;
  friend void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }
};

class AwkwardBirths : public testing::TestWithParam<Place> {};

TEST_P(AwkwardBirths, LoseNothing) {
  for (const std::string fill : {"mean", "split"})
    for (const std::string set : {"d2q5", "d2q9"}) {
      SCOPED_TRACE(fill + " " + set);
      const Scene scene =
          parse_scene(awkward_rock(GetParam().shapes, ""), "case.toml",
                      {"reaction.birth_fill=" + fill, "solute.velocity_set=" + set, "heat.velocity_set=" + set});
      Simulation simulation(scene);
      dissolve_all(simulation, 6000);
      for (int step = 0; step < 3000; ++step) simulation.step();
      simulation.guard();
      // with the rock gone the flow is a plane channel of 8 nodes between pressures 5e-3 apart (lattice units): every
      // opening found its new nodes, also in the corners, where a wall meets the inlet
      for (const Field& field : simulation.fields().lattice) {
        if (field.name != "velocity") continue;
        std::vector<double> v(2 * 12 * 8);
        field.read(v);
        for (int y = 0; y < 8; ++y) {
          EXPECT_NEAR(v[2 * (y * 12)] / v[2 * ((7 - y) * 12)], 1, 1e-6) << "mirrored inflow, row " << y;
          EXPECT_NEAR(v[2 * (y * 12 + 11)] / v[2 * ((7 - y) * 12 + 11)], 1, 1e-6) << "mirrored outflow, row " << y;
          EXPECT_GT(v[2 * (y * 12)], 0);
        }
      }
    }
}

/// Pixels dissolve at every fifth step, as accuracy.update_interval says: at each of them that has something to open.
TEST(BirthsOfARun, ComeWithEveryUpdate) {
  const Scene scene = parse_scene(awkward_rock(rectangle(3, 2, 8, 6), ""), "case.toml");
  Simulation simulation(scene);
  simulation.begin();
  const FluidNodes& fluid = simulation.parts().geometry.fluid;
  int at_odd = 0, at_even = 0;
  for (int step = 1; step <= 3000; ++step) {
    const int before = fluid.count;
    simulation.step();
    if (fluid.count == before) continue;
    ASSERT_EQ(step % 5, 0);
    ++(step / 5 % 2 == 0 ? at_even : at_odd);
  }
  EXPECT_GT(at_odd, 0);
  EXPECT_GT(at_even, 0);
}

/// Without flow, all sides held 50 K below the start: the rock is as cold long before its first pixel opens, so that
/// fluid takes the place of each of its 20 pixels at -50 K, in double precision to the last digits.
TEST(BirthsWithoutFlow, GainWhatFluidHoldsMoreThanRock) {
  std::string box = awkward_rock(rectangle(3, 2, 8, 6), "");
  box.erase(box.find("[flow]"), box.find("[heat]") - box.find("[flow]"));
  box.erase(box.find("[boundary.left]"), box.find("[accuracy]") - box.find("[boundary.left]"));
  for (const std::string side : {"left", "right", "bottom", "top"})
    box += "[boundary." + side + "]\nheat = { type = \"temperature\", temperature = 300 }\n" +
           "solute = { type = \"concentration\", concentration = { A = 1000 } }\n";
  for (const std::string set : {"d2q5", "d2q9"}) {
    SCOPED_TRACE(set);
    Simulation simulation(parse_scene(box, "case.toml", {"reaction.rate_constant=5e-4", "heat.velocity_set=" + set}));
    dissolve_all(simulation, 60000);
    const double gained = (1000.0 * 4000 - 2500.0 * 1000) * -50 * 20 * 1e-6;  // J/m
    const Ledger ledger = simulation.ledger();
    const auto& gains = ledger.balances[0].gains;
    ASSERT_EQ(ledger.balances[0].quantity, "heat");
    const auto births =
        std::find_if(gains.begin(), gains.end(), [](const auto& gain) { return gain.name == "births"; });
    ASSERT_NE(births, gains.end());
    EXPECT_NEAR(births->value / gained, 1, 1e-10);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Places, AwkwardBirths,
    testing::Values(Place{"at the inlet", rectangle(0, 3, 2, 5)}, Place{"at the outlet", rectangle(10, 2, 12, 5)},
                    Place{"in all corners", rectangle(0, 0, 2, 2) + rectangle(10, 0, 12, 2) + rectangle(0, 6, 2, 8) +
                                                rectangle(10, 6, 12, 8)},
                    Place{"lone pixels", rectangle(3, 3, 4, 4) + rectangle(6, 0, 7, 1) + rectangle(8, 5, 9, 6)},
                    Place{"around a closed pore",
                          rectangle(3, 2, 8, 6) + rectangle(5, 3, 6, 4) + "material = \"fluid\"\n"},
                    Place{"a thin wall across, many at once", rectangle(5, 0, 6, 8)}));

}  // namespace
}  // namespace vug
