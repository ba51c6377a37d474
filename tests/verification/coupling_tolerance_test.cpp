// accuracy.tolerance: runs with intervals that are chosen as they go, held against runs in which every step is taken.
#include "coupling/history_difference.hpp"
#include "support/rows.hpp"
#include "support/tolerance_cases.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <tuple>

namespace vug {
namespace {

using test::column;
using test::finest;
using test::with_tolerance;

/// Rows at every look.
History run(const Scene& scene, int steps) {
  return test::rows_of(scene, steps, IntervalChooser::look_interval);
}

/// Acid that diffuses to a slab and dissolves it while heat comes from the left.
const std::string slab =
    "[lattice]\nsize = [40, 8]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 100000\n"
    "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"rectangle\"\nfrom = [20, 0]\nto = [40, 8]\n"
    "[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.2\ninitial_temperature = 300\n"
    "[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = 0.1\ninitial = 1\n"
    "[reaction]\nreactant = \"A\"\nrate_constant = 0.05\nmolar_volume = 0.02\nactivation_energy = 3e4\n"
    "reference_temperature = 300\n"
    "[boundary.left]\nheat = { type = \"temperature\", temperature = 330 }\n"
    "solute = { type = \"concentration\", concentration = { A = 1 } }\n";

/// The same through a layer of a mineral that holds and conducts heat in its own way.
const std::string layers =
    slab +
    "[[mineral]]\nname = \"clay\"\nconductivity = 3e5\ndensity = 2000\nheat_capacity = 900\nmolar_volume = 0.02\n"
    "rate_constant = 0.02\n[[mineral.shapes]]\ntype = \"rectangle\"\nfrom = [26, 0]\nto = [33, 8]\n";

/// Hot acid that a flow carries past grains which react.
const std::string grains =
    "[lattice]\nsize = [60, 24]\nspacing = 1\ntime_step = 1\n[time]\nsteps = 100000\n"
    "[geometry]\ntype = \"shapes\"\n[[geometry.shapes]]\ntype = \"disc\"\ncentre = [22, 12]\nradius = 6\n"
    "[[geometry.shapes]]\ntype = \"disc\"\ncentre = [42, 3]\nradius = 5\n"
    "[flow]\nviscosity = 0.1\ndensity = 1\ninitial_pressure = 0\n"
    "[heat]\nfluid_diffusivity = 0.1\nsolid_diffusivity = 0.2\ninitial_temperature = 300\n"
    "[solute]\n[[solute.species]]\nname = \"A\"\ndiffusivity = 0.05\n"
    "[reaction]\nreactant = \"A\"\nrate_constant = 0.01\nmolar_volume = 1e-3\nactivation_energy = 3e4\n"
    "reference_temperature = 300\n"
    "[boundary.left]\nflow = { type = \"velocity\", velocity = [0.01, 0], ramp_time = 500 }\n"
    "heat = { type = \"temperature\", temperature = 330 }\n"
    "solute = { type = \"concentration\", concentration = { A = 1 } }\n"
    "[boundary.right]\nflow = { type = \"pressure\", pressure = 0 }\nheat = { type = \"outflow\" }\n"
    "solute = { type = \"outflow\" }\n";

/// Share of the steps of heat or solutes that were taken.
double taken(const History& history, const std::string& name) {
  double sum = 0;
  for (const double interval : column(history, name)) sum += 1 / interval;
  return sum / static_cast<double>(history.values[0].size());
}

TEST(Tolerance, HoldsWhatIsPromisedAndSavesStepsForIt) {
  for (const auto& [name, scene] : {std::pair{"slab", slab}, {"layers", layers}, {"grains", grains}}) {
    const History truth = run(parse_scene(scene + finest, "case.toml"), 6400);
    double before = 1.01;
    for (const double tolerance : {1e-4, 1e-3, 1e-2}) {
      const History found = run(parse_scene(scene + with_tolerance(tolerance), "case.toml"), 6400);
      const Difference error = largest_difference(truth, found, {});
      const double heat = taken(found, "heat_interval_1"), solute = taken(found, "solute_interval_1");
      std::printf("    %s, tolerance %g: %.1e (%s), %.2f of the steps of heat, %.2f of the solutes'\n", name, tolerance,
                  error.value, error.column.c_str(), heat, solute);
      EXPECT_LE(error.value, tolerance) << name << ", " << error.column;
      EXPECT_LT(heat, before) << name;
      before = heat;
      EXPECT_LT(solute, tolerance == 1e-2 ? 0.25 : 1.01) << name;
      for (const double balance : column(found, "heat_balance_error_1")) EXPECT_LT(std::abs(balance), 1e-12) << name;
      for (const double balance : column(found, "A_balance_error_1")) EXPECT_LT(std::abs(balance), 1e-12) << name;
    }
  }
}

/// A jump of a given value is known in advance: the look before it shortens what it acts on.
TEST(Tolerance, FallsBackBeforeAGivenValueJumps) {
  const Scene scene = parse_scene(slab + with_tolerance(1e-2), "case.toml",
                                  {"boundary.left.solute.concentration.A=[[0, 1], [4000, 1], [4010, 4]]"});
  const History found = run(scene, 4480);
  EXPECT_EQ(column(found, "solute_interval_1")[30], 8) << "at step 3840";
  EXPECT_EQ(column(found, "solute_interval_1")[31], 1) << "at step 3968";
  EXPECT_LE(column(found, "solute_interval_1")[32], 2) << "at step 4096";
  Simulation simulation(scene);
  for (int step = 0; step < 4000; ++step) simulation.step();
  ASSERT_NE(simulation.chooser(), nullptr);
  EXPECT_THAT(simulation.chooser()->news().back(), testing::HasSubstr("step 3967, 3967 s: solute_interval 8 -> 1"));
}

/// As much as its period is that of the looks, which find it where it was.
TEST(Tolerance, FollowsValuesThatOscillateWithTheLooks) {
  std::string table = "[[0, 300]";
  for (int turn = 1; turn <= 100; ++turn) table += fmt::format(", [{}, {}]", 64 * turn, turn % 2 ? 330 : 300);
  const std::vector<std::string> swing{"boundary.left.heat.temperature=" + table + "]"};
  const History found = run(parse_scene(slab + with_tolerance(1e-2), "case.toml", swing), 6400);
  for (const double interval : column(found, "heat_interval_1")) EXPECT_LE(interval, 2) << "4 tolerances in 64 steps";
  const Difference error = largest_difference(run(parse_scene(slab + finest, "case.toml", swing), 6400), found, {});
  std::printf("    off by %.1e (%s)\n", error.value, error.column.c_str());
  EXPECT_LE(error.value, 1e-2) << error.column;
}

/// What there was none of for thousands of steps: acid that a table brings, and its product where a flow carries it to
/// the first grain.
TEST(Tolerance, HoldsWhereSomethingArrivesLate) {
  const std::vector<std::string> late{
      "solute.species=[{ name = \"A\", diffusivity = 0.1 }, { name = \"B\", diffusivity = 0.1 }]", "reaction.product=B",
      "boundary.left.solute.concentration.A=[[0, 0], [3000, 0], [3010, 1]]"};
  std::vector<std::string> far = late;
  far.front() = "solute.species=[{ name = \"A\", diffusivity = 0.01 }, { name = \"B\", diffusivity = 0.01 }]";
  for (const auto& [name, scene, set] : {std::tuple{"slab", slab, late}, {"grains", grains, far}}) {
    const History truth = run(parse_scene(scene + finest, "case.toml", set), 7680);
    for (const double tolerance : {1e-3, 1e-2}) {
      const History found = run(parse_scene(scene + with_tolerance(tolerance), "case.toml", set), 7680);
      const Difference error = largest_difference(truth, found, {});
      std::printf("    %s, tolerance %g: %.1e (%s), solutes every %g steps before they come\n", name, tolerance,
                  error.value, error.column.c_str(), column(found, "solute_interval_1")[22]);
      EXPECT_LE(error.value, tolerance) << name << ", " << error.column;
      if (tolerance == 1e-2) {
        EXPECT_GE(column(found, "solute_interval_1")[22], 4) << name;
      }
    }
  }
}

/// Largest deviation from a uniform concentration in a flow that starts up between inert grains.
double from_uniform(const std::string& accuracy) {
  const Scene scene = parse_scene(
      grains + accuracy, "case.toml",
      {"reaction.rate_constant=1e-12", "solute.species=[{ name = \"A\", diffusivity = 0.05, initial = 1 }]"});
  Simulation simulation(scene);
  for (int step = 0; step < 6400; ++step) simulation.step();
  double off = 0;
  const FieldList fields = simulation.fields();
  for (const Field& field : fields.lattice) {
    if (field.name != "concentration_A") continue;
    std::vector<double> values(60 * 24);
    field.read(values);
    for (const double value : values)
      if (value != 0) off = std::max(off, std::abs(value - 1));
  }
  return off;
}

/// No change of interval makes anything of what is uniform.
TEST(Tolerance, KeepsWhatIsUniformUniform) {
  const double every_step = from_uniform(finest), changing = from_uniform(with_tolerance(1e-2));
  std::printf("    off by %.1e with every step, %.1e with intervals that change\n", every_step, changing);
  EXPECT_LT(changing, 2 * every_step + 1e-6);
}

}  // namespace
}  // namespace vug
