// Heat through several minerals: in series, side by side, what they hold, and the face at which acid meets them.
#include "support/coupled_run.hpp"
#include "support/record.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace vug {
namespace {

constexpr double dx = 1e-4, dt = 1e-5;
constexpr int nx = 20, ny = 12;
constexpr double width = nx * dx, height = ny * dx;

/// Rock of calcite with quartz where `quartz` says, all of it solid.
std::string rock(const std::string& quartz, const std::string& set) {
  return fmt::format(R"(
[lattice]
size = [0.002, 0.0012]
spacing = 1e-4
time_step = 1e-5
[time]
steps = 1000000
[geometry]
type = "shapes"
background = "solid"
[[geometry.shapes]]
type = "disc"
centre = [-1, -1]
radius = 2
[heat]
fluid_diffusivity = 1.4e-4
solid_diffusivity = 2e-4
fluid_density = 1000
fluid_heat_capacity = 4000
solid_density = 2700
solid_heat_capacity = 820
initial_temperature = 300
velocity_set = "{}"
[[mineral]]
name = "quartz"
conductivity = 1500
density = 2650
heat_capacity = 1100
[[mineral.shapes]]
type = "rectangle"
{}
)",
                     set, quartz);
}

constexpr double calcite = 2e-4 * 2700 * 820, quartz = 1500;  // W/(m K)
const std::string between = R"(
[boundary.left]
heat = { type = "temperature", temperature = 400 }
[boundary.right]
heat = { type = "temperature", temperature = 300 }
[output]
flows = true
)";

const std::string joined = R"(
[boundary.bottom]
heat = { type = "periodic" }
[boundary.top]
heat = { type = "periodic" }
)";

TEST(MineralHeat, SlabsInSeriesShareTheFlux) {
  for (const std::string set : {"d2q5", "d2q9"}) {
    test::CoupledRun run(rock("from = [0, 0]\nto = [0.0007, 0.0012]", set) + between + joined);
    run.steps(20000);
    const double q = 100 / (7 * dx / quartz + 13 * dx / calcite), face = 400 - q * 7 * dx / quartz;  // W/m2, K
    EXPECT_NEAR(run.now("left_heat_flow_W_per_m") / (q * height), 1, 1e-8) << set;
    EXPECT_NEAR(run.now("right_heat_flow_W_per_m") / (-q * height), 1, 1e-8) << set;
    const std::vector<double> T = run.nodes("temperature");
    for (int x = 0; x < nx; ++x) {
      const double at = (x + 0.5) * dx;
      const double exact = x < 7 ? 400 - q * at / quartz : face - q * (at - 7 * dx) / calcite;
      for (const int y : {0, 5, ny - 1}) EXPECT_NEAR(T[y * nx + x], exact, 1e-6) << set << " " << x << " " << y;
    }
    test::record("mineral_heat_series",
                 {{"set", set == "d2q5" ? 5 : 9}, {"flow", run.now("left_heat_flow_W_per_m")}, {"exact", q * height}});
  }
}

TEST(MineralHeat, LayersSideBySideCarryEachItsOwn) {
  for (const std::string set : {"d2q5", "d2q9"}) {
    test::CoupledRun run(rock("from = [0, 0.0008]\nto = [0.002, 0.0012]", set) + between);
    run.steps(20000);
    const double exact = (4 * dx * quartz + 8 * dx * calcite) * 100 / width;  // W/m
    // on D2Q9 diagonal links cross the border between the layers, where that meets a side as well
    const bool straight = set == "d2q5";
    EXPECT_NEAR(run.now("left_heat_flow_W_per_m") / exact, 1, straight ? 1e-8 : 2e-2) << set;
    const std::vector<double> T = run.nodes("temperature");
    for (int x = 0; x < nx; ++x)
      for (const int y : {0, 7, 8, ny - 1})
        EXPECT_NEAR(T[y * nx + x], 400 - 100 * (x + 0.5) / nx, straight ? 1e-6 : 1.0) << set << x;
    test::record("mineral_heat_parallel",
                 {{"set", set == "d2q5" ? 5 : 9}, {"flow", run.now("left_heat_flow_W_per_m")}, {"exact", exact}});
  }
}

/// Heat that has come in through all sides is what the minerals hold at the temperature that they end with.
TEST(MineralHeat, EachHoldsItsOwnCapacity) {
  for (const std::string set : {"d2q5", "d2q9"})
    for (const std::string kind : {"flux", "convection"}) {
      const std::string side = kind == "flux" ? "{ type = \"flux\", flux = [[0, 5e7], [0.00999, 5e7], [0.01, 0]] }"
                                              : "{ type = \"convection\", temperature = 360, coefficient = 2e6 }";
      std::string text = rock("from = [0, 0]\nto = [0.0007, 0.0009]", set);
      for (const char* name : {"left", "right", "bottom", "top"})
        text += fmt::format("[boundary.{}]\nheat = {}\n", name, side);
      test::CoupledRun run(text);
      run.steps(8000);
      const double hot = 7 * 9 * dx * dx, other = width * height - hot;
      const double held = hot * 2650 * 1100 + other * 2700 * 820;  // J/(m K)
      const double brought = run.gain("heat", "sides");
      const double expected = kind == "flux" ? 5e7 * 0.01 * 2 * (width + height) : held * 60;
      EXPECT_NEAR(brought / expected, 1, kind == "flux" ? 2e-3 : 1e-6) << set << kind;
      for (const double T : run.nodes("temperature")) ASSERT_NEAR(T, 300 + brought / held, 1e-5) << set << kind;
      EXPECT_LT(run.worst_balance(), 1e-12) << set << kind;
    }
}

/// The minerals that are all like the rock: nothing of them is stored, and the bits are those without.
TEST(MineralHeat, MineralsLikeTheRockCostNothing) {
  std::string text = rock("from = [0, 0]\nto = [0.0007, 0.0009]", "d2q5") + between;
  const std::string numbers = "conductivity = 1500\ndensity = 2650\nheat_capacity = 1100\n";
  text.replace(text.find(numbers), numbers.size(), "");
  const auto from = text.find("[[mineral]]");
  const std::string plain = text.substr(0, from) + text.substr(text.find("[boundary.left]"));
  test::CoupledRun named(text), unnamed(plain);
  named.steps(500);
  unnamed.steps(500);
  EXPECT_EQ(named.nodes("temperature"), unnamed.nodes("temperature"));
}

/// Acid above calcite and quartz that reacts, whose faces are at the temperatures that their conductivities give.
TEST(MineralHeat, FaceOfEachHasItsOwnTemperature) {
  const std::string column = R"(
[lattice]
size = [0.0014, 0.0016]
spacing = 1e-4
time_step = 1e-5
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0, 0]
to = [0.0014, 0.0006]
[heat]
fluid_diffusivity = 1.4e-4
solid_diffusivity = 2e-4
fluid_density = 1000
fluid_heat_capacity = 4000
solid_density = 2700
solid_heat_capacity = 820
initial_temperature = 320
[solute]
[[solute.species]]
name = "acid"
diffusivity = 1e-4
initial = 1000
[reaction]
reactant = "acid"
rate_constant = 1e-7
activation_energy = 41000
reference_temperature = 310
molar_volume = 1e-9
[[mineral]]
name = "quartz"
conductivity = 1500
density = 2650
heat_capacity = 1100
[[mineral.shapes]]
type = "rectangle"
from = [0, 0]
to = [0.0014, 0.0006]
[boundary.left]
solute = { type = "periodic" }
heat = { type = "periodic" }
[boundary.right]
solute = { type = "periodic" }
heat = { type = "periodic" }
[boundary.bottom]
heat = { type = "temperature", temperature = 420 }
[boundary.top]
solute = { type = "concentration", concentration = { acid = 1000 } }
heat = { type = "temperature", temperature = 300 }
)";
  test::CoupledRun run(column);
  run.steps(20000);
  const double fluid = 1000 * 4000 * 1.4e-4 / (10 * dx), solid = 1500 / (6 * dx);
  const double face = (solid * 420 + fluid * 300) / (solid + fluid);
  const double before = run.gain("acid", "reaction");
  run.steps(200);
  const double flux = (before - run.gain("acid", "reaction")) / (200 * dt * 14 * dx);
  const double rate = 1e-7 * std::exp(-41000 / 8.31446261815324 * (1 / face - 1 / 310.0));
  const double exact = 1000 / (10 * dx / 1e-4 + 1 / rate);
  EXPECT_NEAR(flux / exact, 1, 1e-7);
}

}  // namespace
}  // namespace vug
