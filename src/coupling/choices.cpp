// Measurements of the choices of speed against accuracy (docs/accuracy.md), and which cases make them.
#include "coupling/choices.hpp"

#include "io/presets.hpp"

namespace vug {

bool is_near(double value, double measured) {
  const double ratio = value / measured;
  return ratio * ratio >= 0.5 && ratio * ratio < 2;
}

namespace {

/// Whether the case differs from its preset in a key.
template <class Value>
bool given(const Scene& scene, Value AccuracySection::*key) {
  return scene.accuracy.*key != accuracy_of(preset_of(scene.accuracy.preset)).*key;
}

/// The interval where it differs from the preset and is longer than the default; otherwise 0.
template <int AccuracySection::*key>
double interval(const Scene& scene) {
  const int value = scene.accuracy.*key;
  return given(scene, key) && value > AccuracySection{}.*key ? value : 0;
}

/// The same for a parameter of how the rock moves.
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

bool single(const Scene& s) {
  return s.accuracy.precision == Precision::single_precision;  // whoever chose it
}
bool solute_d2q9(const Scene& s) {
  return s.solute && s.solute->velocity_set == ScalarVelocitySet::d2q9;
}
bool heat_d2q9(const Scene& s) {
  return s.heat && s.heat->velocity_set == ScalarVelocitySet::d2q9;
}

}  // namespace

const std::vector<MeasuredLadder>& measured_ladders() {
  static const std::vector<MeasuredLadder> all = {{"update_interval", {50}, {100}, update_interval},
                                                  {"wall_interval", {50, 100, 400}, {}, wall_interval},
                                                  {"heat_interval", {2, 4}, {2, 4, 8}, heat_interval},
                                                  {"solute_interval", {2, 4}, {2, 4, 8}, solute_interval},
                                                  {"exchange_interval", {2, 4, 8}, {}, exchange_interval},
                                                  {"mass_scaling", {4, 16, 64}, {}, mass_scaling},
                                                  {"rest_tolerance", {2e-3, 5e-3, 2e-2}, {}, rest_tolerance}};
  return all;
}

const std::vector<MeasuredChoice>& measured_choices() {
  using S = const Scene&;
  static const std::vector<MeasuredChoice> choices = {
      {"rock", "preset = balanced", "preset = balanced", "0.68", "3.4e-04",
       [](S s) { return s.accuracy.preset == "balanced"; }},
      {"rock", "preset = fast", "preset = fast", "0.32", "2.2e-05", [](S s) { return s.accuracy.preset == "fast"; }},
      {"rock", "preset = reference", "preset = reference", "1.32", "2.7e-05",
       [](S s) { return s.accuracy.preset == "reference"; }},
      {"rock", "precision = single", "precision = single", "0.90", "4.6e-07", single},
      {"rock", "update_interval = 50", "update_interval = 50", "0.99", "3.0e-05",
       [](S s) { return is_near(update_interval(s), 50); }},
      {"rock", "wall_interval = 50", "wall_interval = 50", "1.02", "2.5e-05",
       [](S s) { return is_near(wall_interval(s), 50); }},
      {"rock", "wall_interval = 100", "wall_interval = 100", "1.00", "4.7e-05",
       [](S s) { return is_near(wall_interval(s), 100); }},
      {"rock", "wall_interval = 400", "wall_interval = 400", "1.02", "5.5e-03",
       [](S s) { return is_near(wall_interval(s), 400); }},
      {"rock", "heat_interval = 2", "heat_interval = 2", "0.96", "2.6e-05",
       [](S s) { return is_near(heat_interval(s), 2); }},
      {"rock", "heat_interval = 4", "heat_interval = 4", "0.93", "1.7e-05",
       [](S s) { return is_near(heat_interval(s), 4); }},
      {"rock", "solute_interval = 2", "solute_interval = 2", "1.00", "1.7e-04",
       [](S s) { return is_near(solute_interval(s), 2); }},
      {"rock", "solute_interval = 4", "solute_interval = 4", "0.99", "3.4e-04",
       [](S s) { return is_near(solute_interval(s), 4); }},
      {"rock", "exchange_interval = 2", "exchange_interval = 2", "0.96", "5.8e-06",
       [](S s) { return is_near(exchange_interval(s), 2); }},
      {"rock", "exchange_interval = 4", "exchange_interval = 4", "0.97", "2.5e-05",
       [](S s) { return is_near(exchange_interval(s), 4); }},
      {"rock", "exchange_interval = 8", "exchange_interval = 8", "0.94", "3.3e-05",
       [](S s) { return is_near(exchange_interval(s), 8); }},
      {"rock", "mass_scaling = 4", "mass_scaling = 4", "0.64", "5.2e-05",
       [](S s) { return is_near(mass_scaling(s), 4); }},
      {"rock", "mass_scaling = 16", "mass_scaling = 16", "0.50", "1.3e-04",
       [](S s) { return is_near(mass_scaling(s), 16); }},
      {"rock", "mass_scaling = 64", "mass_scaling = 64", "0.43", "1.6e-04",
       [](S s) { return is_near(mass_scaling(s), 64); }},
      {"rock", "rest_tolerance = 2e-3", "rest_tolerance = 2e-3", "1.06", "0",
       [](S s) { return is_near(rest_tolerance(s), 2e-3); }},
      {"rock", "rest_tolerance = 5e-3", "rest_tolerance = 5e-3", "1.00", "0",
       [](S s) { return is_near(rest_tolerance(s), 5e-3); }},
      {"rock", "rest_tolerance = 2e-2", "rest_tolerance = 2e-2", "0.78", "6.4e-05",
       [](S s) { return is_near(rest_tolerance(s), 2e-2); }},
      {"rock", "reaction.wall = paper", "reaction.wall = paper", "1.04", "3.4e-02",
       [](S s) { return s.reaction && s.reaction->wall == ReactiveWallLaw::paper; }},
      {"rock", "reaction.surface_normal = false", "reaction.surface_normal = false", "0.91", "7.6e-02",
       [](S s) { return s.reaction && !s.reaction->surface_normal; }},
      {"rock", "solute.velocity_set = d2q9", "solute.velocity_set = d2q9", "1.13", "1.3e-02", solute_d2q9},
      {"rock", "heat.velocity_set = d2q9", "heat.velocity_set = d2q9", "1.31", "8.3e-03", heat_d2q9},
      {"rock", "solute.advective_form = false", "solute.advective_form = false", "0.99", "2.0e-01",
       [](S s) { return s.solute && !s.solute->advective_form; }},
      {"wall", "precision = single", "precision = single", "1.01", "1.3e-04",
       [](S s) { return single(s) && s.solute; }},
      {"channel", "precision = single", "precision = single", "0.78", "1.1e-07",
       [](S s) { return single(s) && s.flow && !s.solute && !s.heat; }},
      {"cooling", "precision = single", "precision = single", "0.80", "9.6e-06",
       [](S s) { return single(s) && s.heat && !s.solute; }},
      {"receding", "update_interval = 100", "update_interval = 100", "0.94", "1.7e-02",
       [](S s) { return is_near(update_interval(s), 100); }},
      {"cooling", "heat_interval = 2", "heat_interval = 2", "0.52", "2.7e-05",
       [](S s) { return is_near(heat_interval(s), 2); }},
      {"cooling", "heat_interval = 4", "heat_interval = 4", "0.28", "1.3e-04",
       [](S s) { return is_near(heat_interval(s), 4); }},
      {"cooling", "heat_interval = 8", "heat_interval = 8", "0.15", "5.4e-04",
       [](S s) { return is_near(heat_interval(s), 8); }},
      {"wall", "solute_interval = 2", "solute_interval = 2", "0.53", "1.3e-04",
       [](S s) { return is_near(solute_interval(s), 2); }},
      {"wall", "solute_interval = 4", "solute_interval = 4", "0.29", "1.3e-04",
       [](S s) { return is_near(solute_interval(s), 4); }},
      {"wall", "solute_interval = 8", "solute_interval = 8", "0.17", "1.3e-04",
       [](S s) { return is_near(solute_interval(s), 8); }},
      {"wall", "velocity_set = d2q9", "solute.velocity_set = d2q9", "2.13", "2.5e-04", solute_d2q9},
      {"cooling", "velocity_set = d2q9", "heat.velocity_set = d2q9", "1.95", "9.6e-06", heat_d2q9},
  };
  return choices;
}

}  // namespace vug
