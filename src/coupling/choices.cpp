// Measurements of the choices of speed against accuracy (docs/accuracy.md), and which cases make them.
#include "coupling/choices.hpp"

#include "io/presets.hpp"

#include <fmt/format.h>

#include <string_view>

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

using S = const Scene&;

bool single(S s) {
  return s.accuracy.precision == Precision::single_precision;  // whoever chose it
}
bool solute_d2q9(S s) {
  return s.solute && s.solute->velocity_set == ScalarVelocitySet::d2q9;
}
bool heat_d2q9(S s) {
  return s.heat && s.heat->velocity_set == ScalarVelocitySet::d2q9;
}

/// A measured value of a number.
struct MeasuredValue {
  std::string_view problem, key;
  const char *value, *cost, *error;
};

constexpr MeasuredValue measured_values[] = {
    {"rock", "update_interval", "50", "0.99", "3.0e-05"},  {"rock", "wall_interval", "50", "1.02", "2.5e-05"},
    {"rock", "wall_interval", "100", "1.00", "4.7e-05"},   {"rock", "wall_interval", "400", "1.02", "5.5e-03"},
    {"rock", "heat_interval", "2", "0.96", "2.6e-05"},     {"rock", "heat_interval", "4", "0.93", "1.7e-05"},
    {"rock", "solute_interval", "2", "1.00", "1.7e-04"},   {"rock", "solute_interval", "4", "0.99", "3.4e-04"},
    {"rock", "exchange_interval", "2", "0.96", "5.8e-06"}, {"rock", "exchange_interval", "4", "0.97", "2.5e-05"},
    {"rock", "exchange_interval", "8", "0.94", "3.3e-05"}, {"rock", "mass_scaling", "4", "0.64", "5.2e-05"},
    {"rock", "mass_scaling", "16", "0.50", "1.3e-04"},     {"rock", "mass_scaling", "64", "0.43", "1.6e-04"},
    {"rock", "rest_tolerance", "2e-3", "1.06", "0"},       {"rock", "rest_tolerance", "5e-3", "1.00", "0"},
    {"rock", "rest_tolerance", "2e-2", "0.78", "6.4e-05"}, {"receding", "update_interval", "100", "0.94", "1.7e-02"},
    {"cooling", "heat_interval", "2", "0.52", "2.7e-05"},  {"cooling", "heat_interval", "4", "0.28", "1.3e-04"},
    {"cooling", "heat_interval", "8", "0.15", "5.4e-04"},  {"wall", "solute_interval", "2", "0.53", "1.3e-04"},
    {"wall", "solute_interval", "4", "0.29", "1.3e-04"},   {"wall", "solute_interval", "8", "0.17", "1.3e-04"},
};

}  // namespace

const std::vector<MeasuredLadder>& measured_ladders() {
  using Accuracy = AccuracySection;
  static const std::vector<MeasuredLadder> all = [] {
    std::vector<MeasuredLadder> ladders = {
        {"update_interval", interval<&Accuracy::update_interval>},
        {"wall_interval", [](S s) { return s.reaction ? interval<&Accuracy::wall_interval>(s) : 0; }},
        {"heat_interval", [](S s) { return s.heat ? interval<&Accuracy::heat_interval>(s) : 0; }},
        {"solute_interval", [](S s) { return s.solute ? interval<&Accuracy::solute_interval>(s) : 0; }},
        {"exchange_interval",
         [](S s) { return s.mechanics && s.flow ? interval<&Accuracy::exchange_interval>(s) : 0; }},
        {"mass_scaling", of_rock<&MechanicsParameters::mass_scaling>},
        {"rest_tolerance", of_rock<&MechanicsParameters::rest_tolerance>}};
    for (MeasuredLadder& ladder : ladders)
      for (const MeasuredValue& m : measured_values)
        if (ladder.key == m.key) (m.problem == "rock" ? ladder.measured : ladder.alone).push_back(std::stod(m.value));
    return ladders;
  }();
  return all;
}

const std::vector<MeasuredChoice>& measured_choices() {
  static const std::vector<MeasuredChoice> all = [] {
    std::vector<MeasuredChoice> choices;
    const auto add = [&](std::string_view problem, const std::string& name, const char* cost, const char* error,
                         const std::function<bool(S)>& made) {
      choices.push_back({std::string(problem), name, name, cost, error, made});
    };
    add("rock", "preset = balanced", "0.68", "3.4e-04", [](S s) { return s.accuracy.preset == "balanced"; });
    add("rock", "preset = fast", "0.32", "2.2e-05", [](S s) { return s.accuracy.preset == "fast"; });
    add("rock", "preset = reference", "1.32", "2.7e-05", [](S s) { return s.accuracy.preset == "reference"; });
    add("rock", "precision = single", "0.90", "4.6e-07", single);
    add("wall", "precision = single", "1.01", "1.3e-04", [](S s) { return single(s) && s.solute; });
    add("channel", "precision = single", "0.78", "1.1e-07",
        [](S s) { return single(s) && s.flow && !s.solute && !s.heat; });
    add("cooling", "precision = single", "0.80", "9.6e-06", [](S s) { return single(s) && s.heat && !s.solute; });
    for (const MeasuredLadder& ladder : measured_ladders())
      for (const MeasuredValue& m : measured_values)
        if (ladder.key == m.key)
          add(m.problem, fmt::format("{} = {}", m.key, m.value), m.cost, m.error,
              [&ladder, value = std::stod(m.value)](S s) { return is_near(ladder.chosen(s), value); });
    add("rock", "reaction.wall = paper", "1.04", "3.4e-02",
        [](S s) { return s.reaction && s.reaction->wall == ReactiveWallLaw::paper; });
    add("rock", "reaction.surface_normal = false", "0.91", "7.6e-02",
        [](S s) { return s.reaction && !s.reaction->surface_normal; });
    add("rock", "solute.velocity_set = d2q9", "1.13", "1.3e-02", solute_d2q9);
    add("rock", "heat.velocity_set = d2q9", "1.31", "8.3e-03", heat_d2q9);
    add("rock", "solute.advective_form = false", "0.99", "2.0e-01",
        [](S s) { return s.solute && !s.solute->advective_form; });
    add("wall", "solute.velocity_set = d2q9", "2.13", "2.5e-04", solute_d2q9);
    choices.back().row = "velocity_set = d2q9";
    add("cooling", "heat.velocity_set = d2q9", "1.95", "9.6e-06", heat_d2q9);
    choices.back().row = "velocity_set = d2q9";
    return choices;
  }();
  return all;
}

}  // namespace vug
