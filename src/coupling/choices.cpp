#include "coupling/choices.hpp"

#include "io/presets.hpp"

#include <fmt/format.h>

namespace vug {

namespace {

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

}  // namespace

const std::vector<MeasuredChoice>& measured_choices() {
  using S = const Scene&;
  static const std::vector<MeasuredChoice> choices = {
      {"preset = balanced", "0.71", "4.9e-05", [](S s) { return s.accuracy.preset == "balanced"; }},
      {"preset = fast", "0.28", "2.5e-04", [](S s) { return s.accuracy.preset == "fast"; }},
      {"preset = reference", "1.36", "5.5e-04", [](S s) { return s.accuracy.preset == "reference"; }},
      {"precision = single", "0.71", "7.4e-06",
       [](S s) {
         return s.accuracy.precision == Precision::single_precision && given(s, &AccuracySection::precision);
       }},
      {"update_interval = 50", "0.81", "3.2e-03", [](S s) { return s.accuracy.update_interval >= 50; }},
      {"heat_interval = 2", "0.80", "1.7e-04",
       [](S s) { return s.heat && s.accuracy.heat_interval == 2 && given(s, &AccuracySection::heat_interval); }},
      {"heat_interval = 4", "0.71", "1.2e-04",
       [](S s) { return s.heat && s.accuracy.heat_interval >= 4 && given(s, &AccuracySection::heat_interval); }},
      {"solute_interval = 2", "0.81", "2.0e-04",
       [](S s) { return s.solute && s.accuracy.solute_interval == 2 && given(s, &AccuracySection::solute_interval); }},
      {"solute_interval = 4", "0.72", "8.9e-04",
       [](S s) { return s.solute && s.accuracy.solute_interval >= 4 && given(s, &AccuracySection::solute_interval); }},
      {"mass_scaling = 4", "0.81", "4.9e-05", [](S s) { return mass_scaled(s, 1, 16); }},
      {"mass_scaling = 16", "0.69", "1.2e-04", [](S s) { return mass_scaled(s, 16, 64); }},
      {"mass_scaling = 64", "0.65", "1.3e-04", [](S s) { return mass_scaled(s, 64, 1e300); }},
      {"reaction.wall = paper", "0.91", "2.5e-02",
       [](S s) { return s.reaction && s.reaction->wall == ReactiveWallLaw::paper; }},
      {"reaction.surface_normal = false", "0.98", "6.8e-02",
       [](S s) { return s.reaction && !s.reaction->surface_normal; }},
      {"solute.velocity_set = d2q9", "1.42", "9.2e-03",
       [](S s) { return s.solute && s.solute->velocity_set == ScalarVelocitySet::d2q9; }},
      {"heat.velocity_set = d2q9", "1.50", "8.4e-03",
       [](S s) { return s.heat && s.heat->velocity_set == ScalarVelocitySet::d2q9; }},
      {"solute.advective_form = false", "0.87", "1.9e-01", [](S s) { return s.solute && !s.solute->advective_form; }},
  };
  return choices;
}

std::vector<std::string> choice_notes(const Scene& scene) {
  std::vector<std::string> notes;
  for (const MeasuredChoice& choice : measured_choices())
    if (choice.made(scene))
      notes.push_back(
          fmt::format("{}: {} of the time of preset = careful, dissolved volume within {} of its, on the paper's rock",
                      choice.name, choice.cost, choice.error));
  return notes;
}

}  // namespace vug
