// What the fluid carries in: amount and heat of a plug flow, in mol and J, for any interval of the steps of heat and
// solute.
#include "coupling/step_times.hpp"
#include "support/case_shapes.hpp"
#include "support/coupled_run.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace vug {
namespace {

/// 60 x 6 cells between walls that move with the fluid, 0.05 m/s; what comes in on the left does not reach the right.
const std::string plug = R"(
[lattice]
size = [0.060, 0.006]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "open"
[flow]
viscosity = 1e-4
[heat]
fluid_diffusivity = 5e-5
solid_diffusivity = 5e-5
fluid_density = 800
fluid_heat_capacity = 2000
initial_temperature = 300
[solute]
[[solute.species]]
name = "A"
diffusivity = 5e-5
[boundary.left]
flow = { type = "velocity", velocity = [0.05, 0] }
heat = { type = "temperature", temperature = 340 }
solute = { type = "concentration", concentration = { A = 700 } }
[boundary.right]
flow = { type = "velocity", velocity = [0.05, 0] }
heat = { type = "outflow" }
solute = { type = "outflow" }
[boundary.bottom]
flow = { type = "wall", velocity = [0.05, 0] }
[boundary.top]
flow = { type = "wall", velocity = [0.05, 0] }
)";

/// Carried in by the flow after it has become uniform: U C H t, and rho c_p U (T - T_0) H t.
TEST(TransportInSI, FluidCarriesItsConcentrationAndItsHeat) {
  for (const std::string interval : {"1", "3"}) {
    test::CoupledRun run(plug, {"accuracy.solute_interval=" + interval, "accuracy.heat_interval=" + interval});
    run.steps(300);
    const double mol = run.gain("A", "injected"), joule = run.now("heat_stored_J_per_m");
    run.steps(300);
    const double carried = 0.05 * 0.006 * 0.3;  // m3 per m of depth in 0.3 s
    EXPECT_NEAR((run.gain("A", "injected") - mol) / (700 * carried), 1, 2e-4) << interval;
    EXPECT_NEAR((run.now("heat_stored_J_per_m") - joule) / (800 * 2000 * 40 * carried), 1, 2e-3) << interval;
  }
}

/// A uniform flow of 0.12 m/s that comes in with the given heat and 2 mol/m3 through the left side, the bottom or a
/// shape, and leaves opposite.
std::string uniform_flow(const std::string& in, const std::string& heat, const std::string& set) {
  const bool upright = in == "bottom", shape = in == "shape.well";
  std::string text = upright ? "[lattice]\nsize = [0.004, 0.016]\n" : "[lattice]\nsize = [0.016, 0.004]\n";
  text += "spacing = 1e-3\ntime_step = 1e-3\n[time]\nsteps = 100000\n[geometry]\n";
  text += shape ? "type = \"shapes\"\n" + test::rectangle(0, 0, 0.002, 0.004, "name = \"well\"") : "type = \"open\"\n";
  const std::string speed = shape ? "speed = 0.12" : upright ? "velocity = [0, 0.12]" : "velocity = [0.12, 0]";
  text += fmt::format(R"(
[flow]
viscosity = 1e-4
[heat]
fluid_diffusivity = 1e-4
solid_diffusivity = 1e-4
initial_temperature = 300
velocity_set = "{0}"
[solute]
velocity_set = "{0}"
[[solute.species]]
name = "A"
diffusivity = 1e-4
[boundary.{1}]
flow = {{ type = "velocity", {2} }}
heat = {{ {3} }}
solute = {{ type = "concentration", concentration = {{ A = 2 }} }}
[boundary.{4}]
flow = {{ type = "outflow" }}
heat = {{ type = "outflow" }}
solute = {{ type = "outflow" }}
)",
                      set, in, speed, heat, upright ? "top" : "right");
  for (const char* side : {upright ? "left" : "bottom", upright ? "right" : "top"})
    text += fmt::format("[boundary.{}]\nflow = {{ type = \"periodic\" }}\n", side);
  return text;
}

/// The fluid inside has what the side says that it has: the even part of D2Q9's equilibrium comes in as well.
TEST(TransportInSI, WhatFlowsInHasTheConcentrationAndTheTemperatureOfItsSide) {
  const std::string given = "type = \"temperature\", temperature = 310",
                    held = "type = \"convection\", temperature = 310, coefficient = 1e12";
  for (const std::string set : {"d2q5", "d2q9"})
    for (const std::string in : {"left", "bottom", "shape.well"})
      for (const std::string& heat : {given, held}) {
        const std::string what = set + ", " + in + ", " + heat;
        test::CoupledRun run(uniform_flow(in, heat, set));
        run.steps(3000);
        const std::vector<double> type = run.nodes("node_type"), T = run.nodes("temperature"),
                                  C = run.nodes("concentration_A");
        for (std::size_t n = 0; n < type.size(); ++n) {
          if (type[n] != 0) continue;
          EXPECT_NEAR(C[n] / 2, 1, 1e-9) << what;
          EXPECT_NEAR(T[n] - 300, 10, heat == given ? 1e-8 : 1e-5) << what;
        }
      }
}

/// 24 x 4 cells of fluid at rest; what the tables over time say comes in on the left.
const std::string still = R"(
[lattice]
size = [0.024, 0.004]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "open"
[heat]
fluid_diffusivity = 1e-4
solid_diffusivity = 1e-4
fluid_density = 800
fluid_heat_capacity = 2000
initial_temperature = 300
[solute]
[[solute.species]]
name = "A"
diffusivity = 1e-4
)";

/// The conditions of the left side.
std::string on_the_left(const std::string& heat, const std::string& solute) {
  return "[boundary.left]\nheat = { " + heat + " }\nsolute = { " + solute + " }\n";
}

/// A pulse of 10 lattice steps, its middle 8 of full height: 9 steps of that, wherever in a longer step it lies.
TEST(TransportInSI, PulseComesInOnceForAnyInterval) {
  for (const int start : {37, 43, 52}) {
    const auto pulse = [&](double height) {
      const double t = start * 1e-3;
      return fmt::format("[[{:.17g}, 0], [{:.17g}, {:g}], [{:.17g}, {:g}], [{:.17g}, 0]]", t, t + 1e-3, height,
                         t + 9e-3, height, t + 10e-3);
    };
    const std::string text = still + on_the_left("type = \"flux\", flux = " + pulse(5e5),
                                                 "type = \"flux\", flux = { A = " + pulse(0.02) + " }");
    const auto expect = [&](const std::vector<std::string>& choice) {
      test::CoupledRun run(text, choice);
      run.steps(128);
      const std::string what = choice[0] + ", from step " + std::to_string(start);
      EXPECT_NEAR(run.gain("heat", "sides") / (5e5 * 9e-3 * 0.004), 1, 1e-9) << what;
      EXPECT_NEAR(run.gain("A", "injected") / (0.02 * 9e-3 * 0.004), 1, 1e-9) << what;
    };
    for (const std::string interval : {"1", "3", "8", "16"})
      expect({"accuracy.heat_interval=" + interval, "accuracy.solute_interval=" + interval});
    expect({"accuracy.tolerance=1e-3", "accuracy.heat_interval=16", "accuracy.solute_interval=16"});
  }
}

/// A pulse of 10 lattice steps in the concentration of what flows in: as much comes in by long steps as by short ones,
/// where the value at one of their lattice steps gives none of it or nearly twice as much.
TEST(TransportInSI, PulseThatTheFlowBringsComesInOnceForAnyInterval) {
  for (const int start : {337, 343, 352}) {
    const auto at = [&](int step) { return (start + step) * 1e-3; };
    const std::string pulse =
        fmt::format("[[{:.17g}, 0], [{:.17g}, 700], [{:.17g}, 700], [{:.17g}, 0]]", at(0), at(1), at(9), at(10));
    const auto injected = [&](int interval) {
      test::CoupledRun run(plug, {"boundary.left.solute.concentration.A=" + pulse,
                                  fmt::format("accuracy.solute_interval={}", interval)});
      run.steps(640);
      return run.gain("A", "injected");
    };
    EXPECT_NEAR(injected(8) / injected(1), 1, 0.02) << start;
  }
}

/// What is told before a step of several lattice steps, at any of them, is what that step takes in.
TEST(TransportInSI, FlowsToldAreThoseOfTheNextStep) {
  const std::string text =
      still + "[output]\nflows = true\n[boundary.top]\nheat = { type = \"flux\", flux = [[0, 0], [0.1, 1e5]] }\n" +
      on_the_left("type = \"temperature\", temperature = [[0, 300], [0.1, 350]]",
                  "type = \"concentration\", concentration = { A = [[0, 0], [0.2, 20]] }");
  for (const int interval : {1, 3, 8}) {
    test::CoupledRun run(text, {fmt::format("accuracy.heat_interval={}", interval),
                                fmt::format("accuracy.solute_interval={}", interval)});
    for (const int before : {0, interval / 2}) {
      run.steps(5 * interval + before);
      const double warmth = run.now("left_heat_flow_W_per_m") + run.now("top_heat_flow_W_per_m");
      const double acid = run.now("left_A_flow_mol_per_m_s");
      const double warmth_so_far = run.gain("heat", "sides"), acid_so_far = run.gain("A", "injected");
      run.steps(interval - before);
      const double seconds = interval * 1e-3;
      EXPECT_NEAR((run.gain("heat", "sides") - warmth_so_far) / seconds / warmth, 1, 1e-9) << interval;
      EXPECT_NEAR((run.gain("A", "injected") - acid_so_far) / seconds / acid, 1, 1e-9) << interval;
    }
  }
}

/// A line: the mean of the steps themselves is the value in their middle, that about the last the value there.
TEST(StepTimes, MeansOfALineAndOfOneStep) {
  const auto line = [](double t) { return 3 + 2 * t; };
  const StepTimes eight{1.7, 0.1, 8}, one{1.7, 0.1, 1};
  EXPECT_NEAR(eight.mean(line), line(1.35), 1e-14);
  EXPECT_NEAR(eight.mean_about_last(line), line(1.7), 1e-14);
  EXPECT_EQ(one.mean(line), line(1.7));
  EXPECT_EQ(one.mean_about_last(line), line(1.7));
}

}  // namespace
}  // namespace vug
