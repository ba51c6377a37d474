// The numbers that `vug check` prints, against their definitions in SI, and what it advises.
#include "io/case_keys.hpp"
#include "support/limits.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>
#include <vector>

namespace vug {
namespace {

constexpr double dx = 2e-3, dt = 1e-3, height = 20 * dx;
const double speed_of_sound = dx / dt / std::sqrt(3.0);

/// A channel, the lower half of whose middle is rock: warm acid is pressed through it. Heat has steps of four, acid of
/// two.
const std::string acid_channel = R"(
[lattice]
size = [0.08, 0.04]
spacing = 2e-3
time_step = 1e-3
[time]
steps = 4
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0.03, 0]
to = [0.05, 0.02]
[flow]
density = 800
viscosity = 4e-4
initial_pressure = 0
gravity = [0, -9.81]
thermal_expansion = 2e-4
reference_temperature = 300
[heat]
fluid_diffusivity = 2e-4
solid_diffusivity = 6e-4
initial_temperature = 300
[[solute.species]]
name = "A"
diffusivity = 3e-4
[reaction]
reactant = "A"
rate_constant = 5e-3
activation_energy = 30000
reference_temperature = 300
molar_volume = 4e-5
stoichiometry = 2
[boundary.left]
flow = { type = "pressure", pressure = 200 }
heat = { type = "temperature", temperature = 320 }
solute = { type = "concentration", concentration = { A = 1000 } }
[boundary.right]
flow = { type = "pressure", pressure = 0 }
heat = { type = "temperature", temperature = 260 }
[accuracy]
heat_interval = 4
solute_interval = 2
dissolution_factor = 50
)";

using Overrides = std::vector<std::string>;
constexpr auto of = test::limit_of;

LimitTable limits_of(const Overrides& overrides) {
  return test::limits_of(acid_channel, overrides);
}

TEST(LimitValues, OfAPressureAreThoseOfBernoulli) {
  const LimitTable limits = limits_of({});
  const double speed = std::sqrt(2 * 200 / 800.0);
  EXPECT_NEAR(of(limits_of({"flow.viscosity=8e-4"}), "flow", "Mach number that the pressures drive").value,
              speed / speed_of_sound, 1e-9);
  EXPECT_NEAR(of(limits, "flow", "pressure difference").value, 200 / 800.0 * dt * dt / (dx * dx), 1e-9);
  EXPECT_NEAR(of(limits, "flow", "relaxation time tau_f").value, 0.5 + 4e-4 * dt / (dx * dx) * 3, 1e-9);
}

/// In a short wide channel the parabola is faster than (2 p/rho)^1/2, and the flow reaches it.
TEST(LimitValues, OfAPressureBoundTheFlowThatItDrives) {
  const double n = 20, length = 20, nu = 1 / 15.0, top = 0.15, pressure = top * 8 * nu * length / (n * n);
  ASSERT_GT(top, 1.3 * std::sqrt(2 * pressure));
  Simulation run(parse_scene(fmt::format(R"(
[lattice]
size = [20, 20]
spacing = 1
time_step = 1
[time]
steps = 8000
[geometry]
type = "open"
[flow]
density = 1
viscosity = {}
initial_pressure = 0
speed_limit = 0.5
[solute]
[[solute.species]]
name = "A"
diffusivity = 0.1
[boundary.left]
flow = {{ type = "pressure", pressure = {}, ramp_time = 2000 }}
[boundary.right]
flow = {{ type = "pressure", pressure = 0 }}
)",
                                         nu, pressure),
                             "a.toml"));
  const LimitTable limits = run.limits();
  const double bound = of(limits, "flow", "Mach number that the pressures drive").value;
  EXPECT_NEAR(bound, std::sqrt(3.0) * top, 1e-9);
  EXPECT_NEAR(of(limits, "solute", "cells per step at the largest speed").value, top, 1e-9);
  for (int step = 0; step < 8000; ++step) run.step();
  const double mach = test::history_value(run, "largest_mach_1");
  EXPECT_LE(mach, 1.001 * bound);
  EXPECT_GT(mach, 0.95 * bound);
}

TEST(LimitValues, OfFreeConvectionAreThoseOfItsFall) {
  const double speed = std::sqrt(9.81 * 2e-4 * (320 - 260) * height);
  EXPECT_NEAR(of(limits_of({}), "flow", "Mach number of free convection").value, speed / speed_of_sound, 1e-9);
}

/// Heat and acid must bear the speed of free convection beside that of the pressures, and alone in a closed cavity.
TEST(LimitValues, OfHeatAndAcidCountFreeConvection) {
  const double falls = std::sqrt(9.81 * 2e-4 * (320 - 260) * height), pressed = std::sqrt(2 * 20 / 800.0);
  const auto expect = [](const LimitTable& limits, double speed) {
    EXPECT_NEAR(of(limits, "heat", "grid Peclet number").value, speed * dx / 2e-4, 1e-9);
    EXPECT_NEAR(of(limits, "heat", "cells per step").value, 4 * speed * dt / dx, 1e-9);
    EXPECT_NEAR(of(limits, "solute", "cells per step").value, 2 * speed * dt / dx, 1e-9);
  };
  expect(limits_of({"boundary.left.flow={ type = \"pressure\", pressure = 20 }"}), falls + pressed);
  expect(limits_of({"boundary.left.flow={ type = \"wall\" }", "boundary.right.flow={ type = \"wall\" }"}), falls);
}

/// Half of the height is open beside the rock.
TEST(LimitValues, OfAVelocityAreTwiceAsHighInTheNarrows) {
  const LimitTable limits = limits_of({"boundary.left.flow={ type = \"velocity\", velocity = [0.1, 0] }"});
  EXPECT_NEAR(of(limits, "flow", "Mach number of the prescribed velocities").value, 0.1 / speed_of_sound, 1e-9);
  EXPECT_NEAR(of(limits, "flow", "Mach number in the narrowest passage").value, 0.2 / speed_of_sound, 1e-9);
}

/// Of a rate over time the largest counts, not that of the start.
TEST(LimitValues, OfARateAreThoseOfItsPeak) {
  for (const char* rate :
       {"flow_rate = [[0, 0], [1, 4e-3], [2, 1e-3]]", "mass_flow_rate = [[0, 0], [1, 3.2], [2, 1]]"}) {
    const LimitTable limits = limits_of({std::string("boundary.left.flow={ type = \"velocity\", ") + rate + " }"});
    EXPECT_NEAR(of(limits, "flow", "Mach number of the prescribed velocities").value, 0.1 / speed_of_sound, 1e-9)
        << rate;
  }
}

/// tau = 1/2 + 3 D dt / dx^2 of a step as long as the interval says.
TEST(LimitValues, OfHeatAndAcidCountTheirOwnSteps) {
  const LimitTable limits = limits_of({});
  EXPECT_NEAR(of(limits, "heat", "relaxation time, fluid").value, 0.5 + 3 * 2e-4 * 4 * dt / (dx * dx), 1e-9);
  EXPECT_NEAR(of(limits, "heat", "relaxation time, solid").value, 0.5 + 3 * 6e-4 * 4 * dt / (dx * dx), 1e-9);
  const double D = 3e-4 * 2 * dt / (dx * dx);
  EXPECT_NEAR(of(limits, "solute", "A diffusivity").value, D, 1e-9);
  EXPECT_NEAR(of(limits, "solute", "A relaxation time tau_1").value, 0.5 + 3 * D, 1e-9);
  EXPECT_NEAR(of(limits, "solute", "A relaxation time tau_h").value, 0.5 + 0.25 / (3 * D), 1e-9);  // Lambda = 1/4
}

TEST(LimitValues, OfAReactionAreItsDamkohlerNumbersAndWhatAcidDissolves) {
  const LimitTable limits = limits_of({});
  const auto damkohler = [](double kelvin) {
    return 5e-3 * std::exp(-30000 / 8.314462618 * (1 / kelvin - 1 / 300.0)) * dx / 3e-4;
  };
  const std::string number = "Damkohler number of a node, k dx/D, ";
  EXPECT_NEAR(of(limits, "reaction", number + "coldest").value, damkohler(260), 1e-9);
  EXPECT_NEAR(of(limits, "reaction", number + "hottest").value, damkohler(320), 1e-9);
  EXPECT_EQ(of(limits, "reaction", "lowest temperature").value, 260);
  EXPECT_EQ(of(limits, "reaction", "highest temperature").value, 320);
  // a mole of rock takes two of acid; it ages fifty times as fast
  EXPECT_NEAR(of(limits, "reaction", "volume dissolved per volume").value, 50 * 4e-5 * 1000 / 2, 1e-9);
  const LimitTable as_fast_as_the_fluid = limits_of({"accuracy.dissolution_factor=1", "reaction.molar_volume=4e-3"});
  EXPECT_NEAR(of(as_fast_as_the_fluid, "reaction", "volume dissolved per volume").value, 2, 1e-9);
  EXPECT_TRUE(of(as_fast_as_the_fluid, "reaction", "volume dissolved per volume").inside()) << "no limit at factor 1";
  // of the acid, whatever salt there is
  const LimitTable salted = limits_of({"solute.species.1={ name = \"salt\", diffusivity = 3e-4, initial = 50000 }"});
  EXPECT_NEAR(of(salted, "reaction", "volume dissolved per volume").value, 50 * 4e-5 * 1000 / 2, 1e-9);
}

/// In single precision the paper's wall subtracts the reaction away (docs/model.md).
TEST(LimitValues, OfASlowReactionAtThePapersWallBoundItInSinglePrecision) {
  const std::string number = "Damkohler number of a node, k dx/D, hottest";
  const auto inside = [&](double rate, const char* precision, const char* wall) {
    const Limit limit = of(limits_of({fmt::format("reaction.rate_constant={}", rate), "reaction.activation_energy=0",
                                      fmt::format("accuracy.precision={}", precision), "solute.velocity_set=d2q5",
                                      fmt::format("reaction.wall={}", wall)}),
                           "reaction", number);
    EXPECT_NEAR(limit.value, rate * dx / 3e-4, 1e-9);
    return limit.inside();
  };
  const double bound = 3e-5 * 3e-4 / dx;
  EXPECT_FALSE(inside(0.99 * bound, "single", "paper"));
  EXPECT_TRUE(inside(1.01 * bound, "single", "paper"));
  EXPECT_TRUE(inside(0, "single", "paper")) << "no reaction, none lost";
  EXPECT_TRUE(inside(0.99 * bound, "double", "paper"));
  EXPECT_TRUE(inside(0.99 * bound, "single", "kinetic"));
}

/// Every key that an advice names is one of the case file's, and every value one that the same case takes.
TEST(Advice, IsWhatTheCaseReaderAccepts) {
  const std::regex setting("([a-z_]+\\.[a-z_]+)(?: = (\"[^\"]*\"|[a-z0-9]+))?");
  const Overrides paper{"solute.velocity_set=d2q9", "solute.relaxation_time=0.9", "reaction.wall=paper",
                        "reaction.order=1", "reaction.surface_normal=false"};
  int values = 0;
  const Overrides slow{"accuracy.precision=single", "reaction.wall=paper", "reaction.rate_constant=1e-9"};
  for (const Overrides& overrides : {Overrides{}, paper, slow})
    for (const Limit& limit : limits_of(overrides))
      for (std::sregex_iterator found(limit.advice.begin(), limit.advice.end(), setting), end; found != end; ++found) {
        const std::string key = (*found)[1], value = (*found)[2];
        if (key.ends_with(".md") || key.starts_with("boundary.")) continue;  // a page; a side, named as a place
        EXPECT_TRUE(std::any_of(case_keys().begin(), case_keys().end(), [&](const auto& k) { return k.key == key; }))
            << limit.advice;
        if (value.empty()) continue;
        ++values;
        Overrides advised = overrides;
        advised.push_back(key + "=" + value);
        EXPECT_NO_THROW(parse_scene(acid_channel, "a.toml", advised)) << limit.advice;
      }
  EXPECT_GE(values, 3);
}

}  // namespace
}  // namespace vug
