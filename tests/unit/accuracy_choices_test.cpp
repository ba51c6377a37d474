// Choices of speed against accuracy: what was measured of them and is quoted, and rock that ages faster.
#include "coupling/choices.hpp"
#include "support/channel_with_pixel.hpp"
#include "support/coupled_run.hpp"
#include "support/run_vug.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace vug {
namespace {

using test::channel_with_pixel;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// The rows of the measurement itself (perf/accuracy_cost): problem, choice, cost, error (of the rock against the
/// default's result), and what was set for it.
struct Measured {
  std::string problem, choice;
  double cost, error;
  std::vector<std::string> overrides;
};

std::vector<Measured> measurements() {
  const test::Outcome read =
      test::run_command(VUG_PYTHON
                        " -c \"import json\n"
                        "for row in json.load(open('" VUG_SOURCE_DIR
                        "/perf/results/accuracy_cost.json'))['rows']:\n"
                        "  given = [k + '=' + (str(v).lower() if isinstance(v, bool) else str(v)) for k, v in "
                        "row['overrides'].items()]\n"
                        "  errors = row['errors']\n"
                        "  error = errors.get('to the default', [*errors.values()][0])\n"
                        "  print(row['problem'], row['choice'], row['cost'], error, *given, sep='\\t')\"");
  std::vector<Measured> rows;
  std::istringstream lines(read.output);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream cells_of_line(line);
    for (std::string cell; std::getline(cells_of_line, cell, '\t');) cells.push_back(cell);
    if (cells.size() < 4) continue;
    rows.push_back({cells[0], cells[1], std::stod(cells[2]), std::stod(cells[3]), {cells.begin() + 4, cells.end()}});
  }
  return rows;
}

/// The case of a problem; the rock of the tests stands for the paper's.
std::string case_of(const std::string& problem) {
  if (problem == "rock") return test::small_rock;
  if (problem == "wall") return VUG_SOURCE_DIR "/cases/diffusion_reaction.toml";
  if (problem == "channel") return VUG_SOURCE_DIR "/cases/poiseuille.toml";
  return VUG_SOURCE_DIR "/perf/accuracy/" + problem + ".toml";
}

/// What is quoted of a choice was measured, to the digits that are quoted, and is quoted of a case that makes it.
TEST(MeasuredChoices, AreThoseOfTheMeasurement) {
  const std::vector<Measured> rows = measurements();
  ASSERT_GT(rows.size(), 50u);
  for (const MeasuredChoice& choice : measured_choices()) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const Measured& m) {
      return m.problem == choice.problem && m.choice == choice.row;
    });
    ASSERT_NE(row, rows.end()) << choice.row;
    EXPECT_NEAR(std::stod(choice.cost), row->cost, 0.00501) << choice.row;
    EXPECT_NEAR(std::stod(choice.error), row->error, 0.0501 * row->error) << choice.row;
    EXPECT_FALSE(row->overrides.empty()) << choice.row;
    const std::vector<std::string> notes = choice_notes(read_scene(case_of(choice.problem), row->overrides));
    const auto note = std::find_if(notes.begin(), notes.end(), [&](const std::string& n) {
      return n.starts_with(fmt::format("{}: {} of the time", choice.name, choice.cost));
    });
    ASSERT_NE(note, notes.end()) << choice.problem << ", " << choice.row;
    if (row->problem == "rock") continue;
    const auto careful = std::find_if(rows.begin(), rows.end(), [&](const Measured& m) {
      return m.problem == choice.problem && m.choice.starts_with("as it is");
    });
    const std::string before = "instead of ";
    ASSERT_NE(careful, rows.end());
    EXPECT_NEAR(std::stod(note->substr(note->find(before) + before.size())), careful->error, 0.0501 * careful->error);
  }
}

std::vector<std::string> notes_of(const std::string& text, const std::vector<std::string>& set) {
  return choice_notes(parse_scene(text, "case.toml", set));
}

/// The paper's rock is quoted where there is mechanics only, whose share of the time makes all else look small.
TEST(MeasuredChoices, AreOfTheRockWhereThereIsMechanicsAndOfOnePhysicsElsewhere) {
  const auto rock = choice_notes(read_scene(test::small_rock, {"accuracy.solute_interval=4"}));
  EXPECT_THAT(rock, Contains(AllOf(StartsWith("solute_interval = 4: 0.99 of"), HasSubstr("on the paper's rock"))));
  const auto minerals = choice_notes(
      read_scene(VUG_SOURCE_DIR "/cases/minerals.toml", {"accuracy.solute_interval=4", "accuracy.heat_interval=8"}));
  EXPECT_THAT(minerals,
              Contains(AllOf(StartsWith("solute_interval = 4: 0.29 of"), HasSubstr("acid diffuses to a wall"))));
  EXPECT_THAT(minerals, Contains(AllOf(StartsWith("heat_interval = 8: 0.15 of"), HasSubstr("heat is conducted"))));
  EXPECT_THAT(minerals, Not(Contains(HasSubstr("paper's rock"))));
}

TEST(MeasuredChoices, AreQuotedForACaseThatMakesThem) {
  EXPECT_TRUE(notes_of(channel_with_pixel, {}).empty());
  EXPECT_THAT(notes_of(channel_with_pixel, {"accuracy.precision=single", "reaction.wall=paper"}),
              ElementsAre(StartsWith("precision = single: 1.0"),
                          "reaction.wall = paper: its speed and error have been measured on the paper's rock only"));
  EXPECT_THAT(notes_of(channel_with_pixel, {"accuracy.preset=fast"}),
              ElementsAre(StartsWith("precision = single: 1.0"), StartsWith("preset = fast: its speed and error")));
  EXPECT_THAT(notes_of(channel_with_pixel, {"accuracy.preset=fast", "accuracy.precision=double"}),
              ElementsAre(StartsWith("preset = fast: its speed and error")));
  EXPECT_THAT(notes_of(channel_with_pixel, {"accuracy.tolerance=1e-2", "accuracy.dissolution_factor=2"}),
              ElementsAre(StartsWith("accuracy.tolerance = 0.01 chooses"), StartsWith("precision = single: 1.0")));
  EXPECT_THAT(notes_of(channel_with_pixel, {"accuracy.tolerance=1e-3", "accuracy.dissolution_factor=2"}),
              ElementsAre(StartsWith("accuracy.tolerance = 0.001 chooses")));
  const auto rock = choice_notes(read_scene(test::small_rock, {"accuracy.precision=single", "reaction.wall=paper"}));
  ASSERT_EQ(rock.size(), 2u);
  for (const std::string& note : rock)  // none claims more than rounding leaves
    EXPECT_GE(std::stod(note.substr(note.find("within ") + 7)), 5e-5) << note;
}

TEST(MeasuredChoices, AreNotQuotedFarFromWhatWasMeasured) {
  const auto begins = [](const std::string& set, const std::string& beginning) {
    EXPECT_THAT(notes_of(channel_with_pixel, {set}), ElementsAre(StartsWith(beginning))) << set;
  };
  begins("accuracy.solute_interval=4", "solute_interval = 4: 0.");
  begins("accuracy.solute_interval=5", "solute_interval = 4: 0.");
  begins("accuracy.solute_interval=300",
         "solute_interval = 300: its speed and error have not been measured; those of 2, 4, 8 have");
  begins("accuracy.wall_interval=200",
         "wall_interval = 200: its speed and error have been measured on the paper's rock only");
  begins("accuracy.update_interval=120", "update_interval = 100: 0.");
  begins("accuracy.update_interval=1000", "update_interval = 1000: its speed and error have not been measured");
  EXPECT_TRUE(notes_of(channel_with_pixel, {"accuracy.heat_interval=300"}).empty());  // no heat in it
  EXPECT_TRUE(notes_of(channel_with_pixel, {"accuracy.update_interval=5"}).empty());  // more careful than careful
}

/// On rock as well, whose values are others.
TEST(MeasuredChoices, AreNotQuotedOfRockFarFromWhatWasMeasured) {
  const auto has = [](const std::string& set, const std::string& beginning) {
    EXPECT_THAT(choice_notes(read_scene(test::small_rock, {set})), Contains(StartsWith(beginning))) << set;
  };
  has("accuracy.wall_interval=200",
      "wall_interval = 200: its speed and error have not been measured; those of 50, 100");
  has("accuracy.wall_interval=120", "wall_interval = 100: 1.00 of the time");
  has("accuracy.solute_interval=10", "solute_interval = 10: its speed and error have not been measured; those of 2, 4");
}

/// In the limit of slow reactions the factor is nothing but time.
TEST(DissolutionFactor, TenTimesAsMuchInATenthOfTheTime) {
  const std::vector<std::string> slow = {"reaction.rate_constant=1e-8", "boundary.left.flow.pressure=0"};
  test::CoupledRun one(channel_with_pixel, slow);
  one.steps(4000);
  std::vector<std::string> ten = slow;
  ten.push_back("accuracy.dissolution_factor=10");
  test::CoupledRun fast(channel_with_pixel, ten);
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
