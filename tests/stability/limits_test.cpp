// What breaks was announced: `vug check` warns of each measured limit before it is reached, and a run that breaks all
// the same stops with an error that names step, field and node.
#include "base/require.hpp"
#include "coupling/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace vug {
namespace {

using testing::HasSubstr;

/// Flow between staircase discs at the viscosity of the paper, with heat and a species; all inside every safe range.
const std::string between_discs = R"(
[lattice]
size = [0.06, 0.04]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "disc"
centre = [0.015, 0.010]
radius = 0.0072
[[geometry.shapes]]
type = "disc"
centre = [0.017, 0.031]
radius = 0.0081
[[geometry.shapes]]
type = "disc"
centre = [0.038, 0.021]
radius = 0.0083
[flow]
viscosity = 8.8e-5
initial_pressure = 0
[heat]
fluid_diffusivity = 5e-5
solid_diffusivity = 14e-5
initial_temperature = 400
[solute]
[[solute.species]]
name = "A"
diffusivity = 5e-5
[reaction]
reactant = "A"
rate_constant = 1e-6
[boundary.left]
flow = { type = "pressure", pressure = 10 }
heat = { type = "temperature", temperature = 300 }
solute = { type = "concentration", concentration = { A = 1000 } }
[boundary.right]
flow = { type = "pressure", pressure = 0 }
heat = { type = "outflow" }
solute = { type = "outflow" }
)";

using Overrides = std::vector<std::string>;

Simulation simulation_of(const std::string& text, const Overrides& overrides) {
  return Simulation(parse_scene(text, "case.toml", overrides));
}

Simulation simulation_of(const Overrides& overrides) {
  return simulation_of(between_discs, overrides);
}

/// Names of the numbers outside their safe range.
std::vector<std::string> warnings(const Simulation& simulation) {
  std::vector<std::string> names;
  for (const Limit& limit : simulation.limits())
    if (!limit.inside()) names.push_back(limit.module + ": " + limit.name);
  return names;
}

TEST(Limits, AreKeptByAnOrdinaryCase) {
  EXPECT_THAT(warnings(simulation_of({})), testing::IsEmpty());
}

const std::string velocity = "boundary.left.flow={ type = \"velocity\", velocity = ";

TEST(Limits, WarnBeforeEachMeasuredEdge) {
  const struct {
    Overrides overrides;
    const char* warning;
  } cases[] = {
      // percolation at 10, 20 and 30 MPa of the paper: the rows of docs/stability.md
      {{"flow.viscosity=1e-5"}, "relaxation time tau_f"},
      {{"flow.viscosity=1e-5", "flow.collision=bgk", "flow.viscosity=0.6e-5"}, "relaxation time tau_f"},
      {{"flow.viscosity=3e-5", "boundary.left.flow.pressure=40"}, "relaxation time tau_f"},
      {{"flow.viscosity=8e-5", "boundary.left.flow.pressure=120"}, "relaxation time tau_f"},
      {{"boundary.left.flow.pressure=150"}, "pressure difference"},
      // D = 0.01 is lost at 0.1
      {{"heat.fluid_diffusivity=1e-5"}, "grid Peclet number at the largest speed"},
      {{"flow.body_force=[1e-3, 0]", "heat.fluid_diffusivity=4e-5"}, "grid Peclet number at the largest speed"},
      // what is prescribed, also where it has to squeeze through
      {{velocity + "[0.3, 0] }"}, "Mach number of the prescribed velocities"},
      {{velocity + "[0.15, 0] }"}, "Mach number in the narrowest passage"},
      {{velocity + "[0.09, 0] }", "flow.viscosity=2e-6", "flow.collision=bgk"}, "growth per step of a plane wave"},
      {{"accuracy.solute_interval=300"}, "cells per step at the largest speed"},
      {{"accuracy.heat_interval=300"}, "cells per step at the largest speed"},
      // memory of the even populations at small D; speed for schemes other than the default
      {{"solute.species.0.diffusivity=5e-7"}, "A diffusivity"},
      {{"solute.species.0.diffusivity=1e-5", "solute.velocity_set=d2q9", "solute.relaxation_time=0.7"},
       "A grid Peclet number at the largest speed"},
      {{"solute.species.0.diffusivity=1e-6", "solute.velocity_set=d2q9", "solute.relaxation_time=0.7"},
       "A growth per step of a plane wave"},
      {{"reaction.wall=paper", "solute.velocity_set=d2q9", "solute.species.0.diffusivity=2e-6"},
       "diffusivity for the paper's wall on D2Q9"},
      // Arrhenius' law is clamped to 250 ... 600 K
      {{"boundary.left.heat.temperature=240"}, "lowest temperature"},
      {{"heat.initial_temperature=700"}, "highest temperature"},
  };
  for (const auto& [overrides, warning] : cases)
    EXPECT_THAT(warnings(simulation_of(overrides)), testing::Contains(HasSubstr(warning))) << overrides.front();
}

TEST(Limits, TrianglesResolveTheFractureEnergyOfTheirBonds) {
  // E G_I / sigma_n^2 = 27.8e9 Pa 20 N/m / (15e6 Pa)^2 = 2.47 mm, of which half is resolved
  const auto rock = [](const Overrides& overrides) {
    return simulation_of(R"(
[lattice]
size = [0.02, 0.02]
spacing = 5e-4
time_step = 1e-5
[time]
steps = 10
[geometry]
type = "rock"
[rock]
element_size = 1.1e-3
[rock.hole]
from = [0, 8e-3]
to = [4e-3, 12e-3]
[flow]
viscosity = 1e-2
initial_pressure = 0
[mechanics]
)",
                         overrides);
  };
  const char* name = "mechanics: mean edge of the bonds";
  EXPECT_THAT(warnings(rock({})), testing::Not(testing::Contains(name)));
  EXPECT_THAT(warnings(rock({"mechanics.bond.normal_strength=0"})), testing::Not(testing::Contains(name)));
  EXPECT_THAT(warnings(rock({"rock.element_size=1.4e-3"})), testing::Contains(name));
  EXPECT_THAT(warnings(rock({"mechanics.bond.normal_strength=20e6"})), testing::Contains(name));
  EXPECT_THAT(warnings(rock({"mechanics.bond.fracture_energy_I=15"})), testing::Contains(name));
}

/// Steps until the guard stops the run; empty when it does not.
std::string divergence(Simulation& simulation, int most_steps) {
  simulation.begin();
  for (int step = 1; step <= most_steps; ++step) {
    simulation.step();
    if (step % 100 > 0) continue;
    try {
      simulation.guard();
    } catch (const StabilityError& error) {
      return error.what();
    }
  }
  return "";
}

TEST(Divergence, IsAnnouncedAndThenNamesStepFieldAndNode) {
  const struct {
    Overrides overrides;
    const char *warning, *field;
  } cases[] = {
      {{"flow.viscosity=1e-8", "flow.speed_limit=0", "boundary.left.flow.pressure=100"},
       "relaxation time tau_f",
       "flow"},
      {{"heat.fluid_diffusivity=1e-7", "boundary.left.flow.pressure=40"},
       "grid Peclet number at the largest speed",
       "heat"},
      {{"solute.species.0.diffusivity=1e-8", "solute.velocity_set=d2q9", "solute.relaxation_time=2",
        "boundary.left.flow.pressure=40"},
       "A grid Peclet number at the largest speed",
       "solute A"},
  };
  for (const auto& [overrides, warning, field] : cases) {
    Simulation simulation = simulation_of(overrides);
    EXPECT_THAT(warnings(simulation), testing::Contains(HasSubstr(warning)));
    const std::string message = divergence(simulation, 4000);
    EXPECT_THAT(message, testing::StartsWith(std::string(field) + " diverged at step "));
    EXPECT_THAT(message, testing::ContainsRegex("node \\([0-9]+, [0-9]+\\)"));
  }
}

/// The advice is about what drives the flow: only a pressure can be ramped.
TEST(Divergence, OfAPrescribedVelocityIsAnnouncedAndAdvisesToLowerIt) {
  Simulation simulation = simulation_of({velocity + "[0.3, 0] }", "flow.speed_limit=0"});
  EXPECT_THAT(warnings(simulation), testing::Contains("flow: Mach number of the prescribed velocities"));
  const std::string message = divergence(simulation, 4000);
  EXPECT_THAT(message, testing::StartsWith("flow diverged at step "));
  EXPECT_THAT(message, HasSubstr("lower the prescribed velocity or the time step"));
  EXPECT_THAT(message, testing::Not(HasSubstr("ramp")));
}

/// A heated pipe across the flow, an opening without any rock beside it, is a stair-step as well.
TEST(Divergence, OfHeatAroundAnOpeningIsAnnouncedToo) {
  const auto pipe = [](double diffusivity) {
    return Simulation(parse_scene(R"(
[lattice]
size = [60, 40]
spacing = 1
time_step = 1
[time]
steps = 100000
[geometry]
[[geometry.shapes]]
type = "disc"
name = "pipe"
centre = [20.3, 19.7]
radius = 7.4
[flow]
viscosity = 0.1
density = 1
initial_pressure = 0
[heat]
solid_diffusivity = 0.1
initial_temperature = 300
fluid_diffusivity = )" + std::to_string(diffusivity) +
                                      R"(
[boundary.shape.pipe]
heat = { type = "temperature", temperature = 301 }
[boundary.left]
flow = { type = "velocity", velocity = [0.1, 0] }
heat = { type = "temperature", temperature = 300 }
[boundary.right]
flow = { type = "pressure", pressure = 0 }
heat = { type = "outflow" }
)",
                                  "pipe.toml"));
  };
  Simulation calm = pipe(0.06), wild = pipe(0.001);
  EXPECT_THAT(warnings(calm), testing::IsEmpty());
  EXPECT_EQ(divergence(calm, 3000), "");
  EXPECT_THAT(warnings(wild), testing::ElementsAre("heat: grid Peclet number at the largest speed"));
  EXPECT_THAT(divergence(wild, 6000), testing::StartsWith("heat diverged at step "));
}

TEST(Survival, OfTheOrdinaryCaseForAsLong) {
  Simulation simulation = simulation_of({});
  EXPECT_EQ(divergence(simulation, 4000), "");
}

}  // namespace
}  // namespace vug
