#include "coupling/choices.hpp"

#include "io/presets.hpp"
#include "io/rock_inertia.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>

namespace vug {

namespace {

/// Two runs that only round differently differ by this much on the paper's rock (docs/accuracy.md).
constexpr const char* rounding = "5e-05";

/// Whether the case says otherwise than its preset.
template <class Value>
bool given(const Scene& scene, Value AccuracySection::*key) {
  return scene.accuracy.*key != accuracy_of(preset_of(scene.accuracy.preset)).*key;
}

/// Whether what was measured at `measured` says something about `value`: it is no further off than the root of two.
bool near(double value, double measured) {
  const double ratio = value / measured;
  return ratio * ratio >= 0.5 && ratio * ratio < 2;
}

/// A number that a case may choose, with the values that were measured (docs/accuracy.md).
struct Ladder {
  const char* key;
  std::vector<double> measured;
  /// What the case chooses otherwise than its preset and dearer in accuracy than `careful`; 0: nothing.
  double (*chosen)(const Scene&);
};

/// Likewise of an interval.
template <int AccuracySection::*key>
double interval(const Scene& scene) {
  const int value = scene.accuracy.*key;
  return given(scene, key) && value > AccuracySection{}.*key ? value : 0;
}

/// Likewise of the way the rock moves.
template <double MechanicsParameters::*key>
double of_rock(const Scene& scene) {
  if (!scene.mechanics) return 0;
  const double value = scene.mechanics->parameters.*key;
  const double preset = mechanics_of(preset_of(scene.accuracy.preset)).parameters.*key;
  return value != preset && value > MechanicsSection{}.parameters.*key ? value : 0;
}

using Accuracy = AccuracySection;
double update_interval(const Scene& s) {
  return interval<&Accuracy::update_interval>(s);
}
double wall_interval(const Scene& s) {
  return s.reaction ? interval<&Accuracy::wall_interval>(s) : 0;
}
double heat_interval(const Scene& s) {
  return s.heat ? interval<&Accuracy::heat_interval>(s) : 0;
}
double solute_interval(const Scene& s) {
  return s.solute ? interval<&Accuracy::solute_interval>(s) : 0;
}
double exchange_interval(const Scene& s) {
  return s.mechanics && s.flow ? interval<&Accuracy::exchange_interval>(s) : 0;
}
double mass_scaling(const Scene& s) {
  return of_rock<&MechanicsParameters::mass_scaling>(s);
}
double rest_tolerance(const Scene& s) {
  return of_rock<&MechanicsParameters::rest_tolerance>(s);
}

const std::vector<Ladder>& ladders() {
  static const std::vector<Ladder> all = {{"update_interval", {50}, update_interval},
                                          {"wall_interval", {50, 100, 400}, wall_interval},
                                          {"heat_interval", {2, 4}, heat_interval},
                                          {"solute_interval", {2, 4}, solute_interval},
                                          {"exchange_interval", {2, 4, 8}, exchange_interval},
                                          {"mass_scaling", {4, 16, 64}, mass_scaling},
                                          {"rest_tolerance", {2e-3, 5e-3, 2e-2}, rest_tolerance}};
  return all;
}

}  // namespace

const std::vector<MeasuredChoice>& measured_choices() {
  using S = const Scene&;
  static const std::vector<MeasuredChoice> choices = {
      {"preset = balanced", "0.68", "3.4e-04", [](S s) { return s.accuracy.preset == "balanced"; }},
      {"preset = fast", "0.32", "2.2e-05", [](S s) { return s.accuracy.preset == "fast"; }},
      {"preset = reference", "1.32", "2.7e-05", [](S s) { return s.accuracy.preset == "reference"; }},
      {"precision = single", "0.89", "2.0e-07",
       [](S s) {
         return s.accuracy.precision == Precision::single_precision && given(s, &AccuracySection::precision);
       }},
      {"update_interval = 50", "0.99", "3.0e-05", [](S s) { return near(update_interval(s), 50); }},
      {"wall_interval = 50", "1.02", "2.5e-05", [](S s) { return near(wall_interval(s), 50); }},
      {"wall_interval = 100", "1.00", "4.7e-05", [](S s) { return near(wall_interval(s), 100); }},
      {"wall_interval = 400", "1.02", "5.5e-03", [](S s) { return near(wall_interval(s), 400); }},
      {"heat_interval = 2", "0.96", "2.6e-05", [](S s) { return near(heat_interval(s), 2); }},
      {"heat_interval = 4", "0.93", "1.7e-05", [](S s) { return near(heat_interval(s), 4); }},
      {"solute_interval = 2", "1.00", "1.7e-04", [](S s) { return near(solute_interval(s), 2); }},
      {"solute_interval = 4", "0.99", "3.4e-04", [](S s) { return near(solute_interval(s), 4); }},
      {"exchange_interval = 2", "0.96", "5.8e-06", [](S s) { return near(exchange_interval(s), 2); }},
      {"exchange_interval = 4", "0.97", "2.5e-05", [](S s) { return near(exchange_interval(s), 4); }},
      {"exchange_interval = 8", "0.94", "3.3e-05", [](S s) { return near(exchange_interval(s), 8); }},
      {"mass_scaling = 4", "0.64", "5.2e-05", [](S s) { return near(mass_scaling(s), 4); }},
      {"mass_scaling = 16", "0.50", "1.3e-04", [](S s) { return near(mass_scaling(s), 16); }},
      {"mass_scaling = 64", "0.43", "1.6e-04", [](S s) { return near(mass_scaling(s), 64); }},
      {"rest_tolerance = 2e-3", "1.06", "0", [](S s) { return near(rest_tolerance(s), 2e-3); }},
      {"rest_tolerance = 5e-3", "1.00", "0", [](S s) { return near(rest_tolerance(s), 5e-3); }},
      {"rest_tolerance = 2e-2", "0.78", "6.4e-05", [](S s) { return near(rest_tolerance(s), 2e-2); }},
      {"reaction.wall = paper", "1.04", "3.4e-02",
       [](S s) { return s.reaction && s.reaction->wall == ReactiveWallLaw::paper; }},
      {"reaction.surface_normal = false", "0.91", "7.6e-02",
       [](S s) { return s.reaction && !s.reaction->surface_normal; }},
      {"solute.velocity_set = d2q9", "1.13", "1.3e-02",
       [](S s) { return s.solute && s.solute->velocity_set == ScalarVelocitySet::d2q9; }},
      {"heat.velocity_set = d2q9", "1.31", "8.3e-03",
       [](S s) { return s.heat && s.heat->velocity_set == ScalarVelocitySet::d2q9; }},
      {"solute.advective_form = false", "0.99", "2.0e-01", [](S s) { return s.solute && !s.solute->advective_form; }},
  };
  return choices;
}

std::vector<std::string> choice_notes(const Scene& scene) {
  std::vector<std::string> notes;
  if (scene.accuracy.chooses_intervals()) {
    notes.push_back(
        fmt::format("accuracy.tolerance = {:g} chooses the intervals of [accuracy] as the run goes; "
                    "docs/tuning.md has what that gained and cost",
                    scene.accuracy.tolerance));
    if (scene.mechanics && scene.mechanics->scaling_chosen) notes.push_back(mass_scaling_note(scene));
    return notes;
  }
  for (const MeasuredChoice& choice : measured_choices())
    if (choice.made(scene))
      notes.push_back(fmt::format(
          "{}: {} of the time of preset = careful, dissolved volume within {} of its, on the paper's rock", choice.name,
          choice.cost, std::stod(choice.error) < std::stod(rounding) ? rounding : choice.error));
  for (const Ladder& ladder : ladders()) {
    const double value = ladder.chosen(scene);
    const auto known = [&](double measured) { return near(value, measured); };
    if (value == 0 || std::any_of(ladder.measured.begin(), ladder.measured.end(), known)) continue;
    notes.push_back(fmt::format("{} = {:g}: what it gains and costs was not measured; it was at {:g}", ladder.key,
                                value, fmt::join(ladder.measured, ", ")));
  }
  return notes;
}

}  // namespace vug
