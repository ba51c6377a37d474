// What `vug check` says about the choices of a case.
#include "coupling/choices.hpp"
#include "io/rock_inertia.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>

namespace vug {

namespace {

/// Difference on the paper's rock between two runs that differ in rounding only (docs/accuracy.md).
constexpr const char* rounding = "5e-05";

std::string on_the_rock(const MeasuredChoice& choice) {
  return fmt::format("{}: {} of the time of preset = careful, dissolved volume within {} of its, on the paper's rock",
                     choice.name, choice.cost, std::stod(choice.error) < std::stod(rounding) ? rounding : choice.error);
}

/// A problem with one physics for which choices were measured.
struct Problem {
  const char* name;
  const char* of;       // quantity whose error was measured
  const char* where;    // what is computed there
  const char* careful;  // error of preset = careful
};

constexpr std::array<Problem, 4> problems{{{"wall", "concentration", "acid diffuses to a wall", "1.3e-04"},
                                           {"channel", "velocity", "fluid flows through a channel", "5.7e-09"},
                                           {"cooling", "temperature", "heat is conducted", "9.6e-06"},
                                           {"receding", "recession", "a wall dissolves", "1.7e-02"}}};

std::string alone(const MeasuredChoice& choice) {
  const Problem& problem =
      *std::find_if(problems.begin(), problems.end(), [&](const Problem& p) { return p.name == choice.problem; });
  return fmt::format(
      "{}: {} of the time of preset = careful, error of the {} {} instead of {}, where {} and nothing "
      "else is computed",
      choice.name, choice.cost, problem.of, choice.error, problem.careful, problem.where);
}

/// Adds a note where a value is far from all that were measured.
void note_unknown(const char* key, double value, const std::vector<double>& measured, std::vector<std::string>& notes) {
  if (std::any_of(measured.begin(), measured.end(), [&](double one) { return is_near(value, one); })) return;
  notes.push_back(fmt::format("{} = {:g}: its speed and error have not been measured; those of {:g} have", key, value,
                              fmt::join(measured, ", ")));
}

bool is_of_rock(const MeasuredChoice& choice) {
  return choice.problem == "rock";
}

bool is_of_ladder(const std::string& name) {
  return std::any_of(measured_ladders().begin(), measured_ladders().end(),
                     [&](const MeasuredLadder& l) { return name.starts_with(l.key); });
}

/// Notes for a case without mechanics. Moving and breaking rock takes most of the time of the paper's rock, so what a
/// choice gains there says nothing about other cases.
std::vector<std::string> notes_without_mechanics(const Scene& scene) {
  const auto only_there = [](const std::string& choice) {
    return choice + ": its speed and error have been measured on the paper's rock only";
  };
  std::vector<std::string> notes, told;
  for (const MeasuredChoice& choice : measured_choices()) {
    if (is_of_rock(choice) || !choice.made(scene)) continue;
    notes.push_back(alone(choice));
    told.emplace_back(choice.name);
  }
  for (const MeasuredChoice& choice : measured_choices())
    if (is_of_rock(choice) && choice.made(scene) && !is_of_ladder(choice.name) &&
        std::find(told.begin(), told.end(), choice.name) == told.end())
      notes.push_back(only_there(choice.name));
  for (const MeasuredLadder& ladder : measured_ladders()) {
    const double value = ladder.chosen(scene);
    if (value != 0 && ladder.alone.empty()) notes.push_back(only_there(fmt::format("{} = {:g}", ladder.key, value)));
    if (value != 0 && !ladder.alone.empty()) note_unknown(ladder.key, value, ladder.alone, notes);
  }
  return notes;
}

/// Notes for a case with mechanics.
std::vector<std::string> notes_of_rock(const Scene& scene) {
  std::vector<std::string> notes;
  for (const MeasuredChoice& choice : measured_choices())
    if (is_of_rock(choice) && choice.made(scene)) notes.push_back(on_the_rock(choice));
  for (const MeasuredLadder& ladder : measured_ladders())
    if (const double value = ladder.chosen(scene); value != 0) note_unknown(ladder.key, value, ladder.measured, notes);
  return notes;
}

}  // namespace

std::vector<std::string> choice_notes(const Scene& scene) {
  const auto notes_of = [&] { return scene.mechanics ? notes_of_rock(scene) : notes_without_mechanics(scene); };
  if (!scene.accuracy.chooses_intervals()) return notes_of();
  std::vector<std::string> notes{
      fmt::format("accuracy.tolerance = {:g} chooses the intervals of [accuracy] during the run; docs/tuning.md has "
                  "measured speeds and errors",
                  scene.accuracy.tolerance)};
  for (std::string& note : notes_of())
    if (note.starts_with("precision = ")) notes.push_back(std::move(note));
  if (scene.mechanics && scene.mechanics->scaling_chosen) notes.push_back(mass_scaling_note(scene));
  return notes;
}

}  // namespace vug
