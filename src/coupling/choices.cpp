#include "coupling/choices.hpp"

#include "io/presets.hpp"

#include <fmt/format.h>

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

/// Masses scaled by a factor above `low` (or equal, beyond 1) and below `high`, otherwise than by the preset.
bool mass_scaled(const Scene& scene, double low, double high) {
  if (!scene.mechanics) return false;
  const double scaling = scene.mechanics->parameters.mass_scaling;
  const double preset = mechanics_of(preset_of(scene.accuracy.preset)).parameters.mass_scaling;
  return scaling > 1 && scaling >= low && scaling < high && scaling != preset;
}

/// Rock that sleeps from `low` on and below `high`, otherwise than by the preset.
bool rests(const Scene& scene, double low, double high) {
  if (!scene.mechanics) return false;
  const double tolerance = scene.mechanics->parameters.rest_tolerance;
  const double preset = mechanics_of(preset_of(scene.accuracy.preset)).parameters.rest_tolerance;
  return tolerance >= low && tolerance < high && tolerance != preset;
}

}  // namespace

const std::vector<MeasuredChoice>& measured_choices() {
  using S = const Scene&;
  static const std::vector<MeasuredChoice> choices = {
      {"preset = balanced", "0.57", "4.9e-05", [](S s) { return s.accuracy.preset == "balanced"; }},
      {"preset = fast", "0.31", "1.7e-05", [](S s) { return s.accuracy.preset == "fast"; }},
      {"preset = reference", "1.29", "1.7e-05", [](S s) { return s.accuracy.preset == "reference"; }},
      {"precision = single", "0.86", "1.8e-05",
       [](S s) {
         return s.accuracy.precision == Precision::single_precision && given(s, &AccuracySection::precision);
       }},
      {"update_interval = 50", "0.96", "9.3e-05", [](S s) { return s.accuracy.update_interval >= 50; }},
      {"wall_interval = 50", "0.98", "1.8e-05",
       [](S s) {
         return s.reaction && s.accuracy.wall_interval >= 50 && s.accuracy.wall_interval < 400 &&
                given(s, &AccuracySection::wall_interval);
       }},
      {"wall_interval = 400", "0.96", "1.3e-03",
       [](S s) { return s.reaction && s.accuracy.wall_interval >= 400 && given(s, &AccuracySection::wall_interval); }},
      {"heat_interval = 2", "0.92", "1.8e-05",
       [](S s) { return s.heat && s.accuracy.heat_interval == 2 && given(s, &AccuracySection::heat_interval); }},
      {"heat_interval = 4", "0.88", "1.1e-05",
       [](S s) { return s.heat && s.accuracy.heat_interval >= 4 && given(s, &AccuracySection::heat_interval); }},
      {"solute_interval = 2", "1.03", "1.6e-04",
       [](S s) { return s.solute && s.accuracy.solute_interval == 2 && given(s, &AccuracySection::solute_interval); }},
      {"solute_interval = 4", "1.01", "3.5e-04",
       [](S s) { return s.solute && s.accuracy.solute_interval >= 4 && given(s, &AccuracySection::solute_interval); }},
      {"exchange_interval = 2", "1.02", "2.7e-05",
       [](S s) {
         return s.mechanics && s.flow && s.accuracy.exchange_interval >= 2 && s.accuracy.exchange_interval < 8 &&
                given(s, &AccuracySection::exchange_interval);
       }},
      {"exchange_interval = 8", "0.97", "2.9e-05",
       [](S s) {
         return s.mechanics && s.flow && s.accuracy.exchange_interval >= 8 &&
                given(s, &AccuracySection::exchange_interval);
       }},
      {"mass_scaling = 4", "0.68", "4.7e-05", [](S s) { return mass_scaled(s, 1, 16); }},
      {"mass_scaling = 16", "0.52", "1.3e-04", [](S s) { return mass_scaled(s, 16, 64); }},
      {"mass_scaling = 64", "0.43", "1.6e-04", [](S s) { return mass_scaled(s, 64, 1e300); }},
      {"rest_tolerance = 2e-3", "0.97", "7.2e-06", [](S s) { return rests(s, 1e-3, 5e-3); }},
      {"rest_tolerance = 5e-3", "1.05", "4.0e-07", [](S s) { return rests(s, 5e-3, 2e-2); }},
      {"rest_tolerance = 2e-2", "0.75", "2.7e-04", [](S s) { return rests(s, 2e-2, 1e300); }},
      {"reaction.wall = paper", "1.04", "2.5e-02",
       [](S s) { return s.reaction && s.reaction->wall == ReactiveWallLaw::paper; }},
      {"reaction.surface_normal = false", "0.98", "6.8e-02",
       [](S s) { return s.reaction && !s.reaction->surface_normal; }},
      {"solute.velocity_set = d2q9", "1.15", "9.0e-03",
       [](S s) { return s.solute && s.solute->velocity_set == ScalarVelocitySet::d2q9; }},
      {"heat.velocity_set = d2q9", "1.23", "8.4e-03",
       [](S s) { return s.heat && s.heat->velocity_set == ScalarVelocitySet::d2q9; }},
      {"solute.advective_form = false", "0.99", "2.0e-01", [](S s) { return s.solute && !s.solute->advective_form; }},
  };
  return choices;
}

std::vector<std::string> choice_notes(const Scene& scene) {
  std::vector<std::string> notes;
  for (const MeasuredChoice& choice : measured_choices())
    if (choice.made(scene))
      notes.push_back(fmt::format(
          "{}: {} of the time of preset = careful, dissolved volume within {} of its, on the paper's rock", choice.name,
          choice.cost, std::stod(choice.error) < std::stod(rounding) ? rounding : choice.error));
  return notes;
}

}  // namespace vug
