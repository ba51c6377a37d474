// Choices of speed against accuracy that change what is computed: a held flow, and rock that ages faster.
#include "coupling/choices.hpp"
#include "support/coupled_run.hpp"
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace vug {
namespace {

/// A channel with a pixel of rock in it, which acid takes away.
const std::string channel = R"(
[lattice]
size = [0.024, 0.009]
spacing = 1e-3
time_step = 1e-3
[time]
steps = 100000
[geometry]
type = "shapes"
[[geometry.shapes]]
type = "rectangle"
from = [0.010, 0]
to = [0.013, 0.004]
[flow]
viscosity = 2e-4
initial_pressure = 0
[solute]
[[solute.species]]
name = "A"
diffusivity = 1e-4
initial = 1000
[reaction]
reactant = "A"
rate_constant = 2e-4
molar_volume = 4e-4
[boundary.left]
flow = { type = "pressure", pressure = 5, ramp_time = 0.5 }
solute = { type = "concentration", concentration = { A = 1000 } }
[boundary.right]
flow = { type = "pressure", pressure = 0 }
solute = { type = "outflow" }
[accuracy]
guard_interval = 20
)";

/// The rows of the measurement itself (perf/accuracy_cost) on the paper's rock: choice, cost, error against the
/// default's result, and what was set for it.
struct Measured {
  std::string choice;
  double cost, error;
  std::vector<std::string> overrides;
};

std::vector<Measured> measurements() {
  const test::Outcome read =
      test::run_command(VUG_PYTHON
                        " -c \"import json\n"
                        "for row in json.load(open('" VUG_SOURCE_DIR
                        "/perf/results/accuracy_cost.json'))['rows']:\n"
                        "  if row['problem'] == 'rock':\n"
                        "    given = [k + '=' + (str(v).lower() if isinstance(v, bool) else str(v)) for k, v in "
                        "row['overrides'].items()]\n"
                        "    print(row['choice'], row['cost'], row['errors']['to the default'], *given, sep='\\t')\"");
  std::vector<Measured> rows;
  std::istringstream lines(read.output);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream cells_of_line(line);
    for (std::string cell; std::getline(cells_of_line, cell, '\t');) cells.push_back(cell);
    if (cells.size() < 3) continue;
    rows.push_back({cells[0], std::stod(cells[1]), std::stod(cells[2]), {cells.begin() + 3, cells.end()}});
  }
  return rows;
}

/// What is quoted of a choice was measured, to the digits that are quoted, and is quoted of a case that makes it.
TEST(MeasuredChoices, AreThoseOfTheMeasurement) {
  const std::vector<Measured> rows = measurements();
  ASSERT_GT(rows.size(), 20u);
  for (const MeasuredChoice& choice : measured_choices()) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Measured& m) { return m.choice == choice.name; });
    ASSERT_NE(row, rows.end()) << choice.name;
    EXPECT_NEAR(std::stod(choice.cost), row->cost, 0.00501) << choice.name;
    EXPECT_NEAR(std::stod(choice.error), row->error, 0.0501 * row->error) << choice.name;
    EXPECT_FALSE(row->overrides.empty()) << choice.name;
    const std::vector<std::string> notes = choice_notes(read_scene(test::small_rock, row->overrides));
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
      return note.starts_with(std::string(choice.name) + ": ");
    })) << choice.name;
  }
}

TEST(MeasuredChoices, AreQuotedForACaseThatMakesThem) {
  EXPECT_TRUE(choice_notes(parse_scene(channel, "case.toml")).empty());
  const auto notes =
      choice_notes(parse_scene(channel, "case.toml", {"accuracy.precision=single", "reaction.wall=paper"}));
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0].rfind("precision = single: ", 0), 0u);
  EXPECT_EQ(notes[1].rfind("reaction.wall = paper: ", 0), 0u);
  for (const std::string& note : notes)  // none claims more than rounding leaves
    EXPECT_GE(std::stod(note.substr(note.find("within ") + 7)), 5e-5) << note;
  EXPECT_EQ(choice_notes(parse_scene(channel, "case.toml", {"accuracy.preset=fast"})).size(), 1u);
}

TEST(MeasuredChoices, AreNotQuotedFarFromWhatWasMeasured) {
  const auto notes = [](const std::string& override_text) {
    return choice_notes(parse_scene(channel, "case.toml", {override_text}));
  };
  const auto begins = [&](const std::string& override_text, const std::string& beginning) {
    const auto found = notes(override_text);
    ASSERT_EQ(found.size(), 1u) << override_text;
    EXPECT_EQ(found[0].rfind(beginning, 0), 0u) << found[0];
  };
  const auto quoted = [](const std::string& name) {
    for (const MeasuredChoice& choice : measured_choices())
      if (name == choice.name) return name + ": " + choice.cost + " of the time";
    return std::string("no such choice");
  };
  begins("accuracy.solute_interval=4", quoted("solute_interval = 4"));
  begins("accuracy.solute_interval=5", quoted("solute_interval = 4"));
  begins("accuracy.solute_interval=300",
         "solute_interval = 300: what it gains and costs was not measured; it was at 2, 4");
  begins("accuracy.wall_interval=200", "wall_interval = 200: what it gains and costs was not measured");
  begins("accuracy.wall_interval=120", quoted("wall_interval = 100"));
  begins("accuracy.update_interval=1000", "update_interval = 1000: what it gains and costs was not measured");
  EXPECT_TRUE(notes("accuracy.heat_interval=300").empty());  // no heat in it
  EXPECT_TRUE(notes("accuracy.update_interval=5").empty());  // more careful than careful
}

/// Runs n steps with the checks that `vug run` makes.
void steps(test::CoupledRun& run, int n) {
  for (int step = 0; step < n; step += 20) run.steps(20);
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(HeldFlow, IsHeldOnceItIsSteadyAndNotBeforeThePressureIsRaised) {
  test::CoupledRun always(channel), held(channel, {"accuracy.flow_tolerance=1e-5"});
  steps(held, 500);
  EXPECT_EQ(held.now("flow_held_steps_1"), 0);
  steps(held, 3500);
  steps(always, 4000);
  EXPECT_GT(held.now("flow_held_steps_1"), 1000);
  const auto exact = always.nodes("velocity"), found = held.nodes("velocity");
  const double speed = largest_difference(exact, std::vector<double>(exact.size(), 0));
  // it decays by a tenth or more between two looks, so what was still to come is ten times the last change at most
  EXPECT_LE(largest_difference(exact, found), 1e-4 * speed);
  EXPECT_LE(largest_difference(always.nodes("concentration_A"), held.nodes("concentration_A")), 1e-3 * 1000);
  EXPECT_LE(std::abs(held.now("fluid_mass_balance_error_1")), 1e-13);
  EXPECT_LE(std::abs(held.now("A_balance_error_1")), 1e-13);
}

/// A tolerance below what rounding leaves of the velocity: what changes no more but for that is steady.
TEST(HeldFlow, IsHeldInSinglePrecisionWhateverTheTolerance) {
  test::CoupledRun always(channel), held(channel, {"accuracy.flow_tolerance=1e-9", "accuracy.precision=single"});
  steps(always, 8000);
  steps(held, 8000);
  EXPECT_GT(held.now("flow_held_steps_1"), 1000);
  const auto exact = always.nodes("velocity"), found = held.nodes("velocity");
  const double speed = largest_difference(exact, std::vector<double>(exact.size(), 0));
  EXPECT_LE(largest_difference(exact, found), 1e-4 * speed);
}

TEST(HeldFlow, WakesWhenAPixelDissolves) {
  test::CoupledRun always(channel), held(channel, {"accuracy.flow_tolerance=1e-4"});
  const double nodes = held.now("fluid_nodes_1");
  int n = 0;
  for (; n < 60000 && held.now("fluid_nodes_1") < nodes + 6; n += 20) held.steps(20);
  ASSERT_LT(n, 60000);
  const double passed = held.now("flow_held_steps_1");
  EXPECT_GT(passed, 0.5 * n);
  steps(held, 40);
  EXPECT_EQ(held.now("flow_held_steps_1"), passed);  // two looks at least
  steps(always, n + 40);
  EXPECT_NEAR(held.now("dissolved_volume_m3_per_m") / always.now("dissolved_volume_m3_per_m"), 1, 1e-3);
  EXPECT_LE(std::abs(held.now("A_balance_error_1")), 1e-13);
}

TEST(HeldFlow, HasItsBitsWhateverElseIsLookedAt) {
  test::CoupledRun run(channel, {"accuracy.flow_tolerance=1e-5"}), looked_at(channel, {"accuracy.flow_tolerance=1e-5"});
  steps(run, 4000);
  for (int step = 0; step < 4000; step += 10) looked_at.steps(10);  // guards between the looks
  EXPECT_EQ(run.nodes("velocity"), looked_at.nodes("velocity"));
  EXPECT_EQ(run.nodes("concentration_A"), looked_at.nodes("concentration_A"));
}

/// In the limit of slow reactions the factor is nothing but time.
TEST(DissolutionFactor, TenTimesAsMuchInATenthOfTheTime) {
  const std::vector<std::string> slow = {"reaction.rate_constant=1e-8", "boundary.left.flow.pressure=0"};
  test::CoupledRun one(channel, slow);
  one.steps(4000);
  std::vector<std::string> ten = slow;
  ten.push_back("accuracy.dissolution_factor=10");
  test::CoupledRun fast(channel, ten);
  fast.steps(400);
  const double exact = one.now("dissolved_volume_m3_per_m");
  EXPECT_GT(exact, 0);
  // k L/D = 1e-6 is what the acid's own transient is worth
  EXPECT_NEAR(fast.now("dissolved_volume_m3_per_m") / exact, 1, 1e-5);
  EXPECT_LE(std::abs(fast.now("dissolved_volume_balance_error_1")), 1e-12);
  EXPECT_LE(std::abs(fast.now("solid_volume_balance_error_1")), 1e-12);
}

}  // namespace
}  // namespace vug
