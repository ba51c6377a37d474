#include "coupling/interval_warnings.hpp"

#include "coupling/ageing_looks.hpp"
#include "coupling/output_schedule.hpp"
#include "io/each_boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace vug {

namespace {

/// An interval of a case that has what it is for.
struct Held {
  const char* key;
  int interval;
  const char* never;  ///< what does not happen in a run that is shorter
  const char* old;    ///< what rows show as it was, null where they show the present
};

std::vector<Held> held_by(const Scene& scene) {
  const AccuracySection& accuracy = scene.accuracy;
  std::vector<Held> all;
  if (scene.heat) all.push_back({"heat_interval", accuracy.heat_interval, "no temperature changes", "temperatures"});
  if (scene.solute)
    all.push_back({"solute_interval", accuracy.solute_interval, "no concentration changes", "concentrations"});
  if (scene.flow && scene.mechanics)
    all.push_back({"exchange_interval", accuracy.exchange_interval,
                   "the rock bears the force that the fluid has at the start", nullptr});
  return all;
}

void warn_of_short_run(const Scene& scene, std::vector<Held> held, std::vector<std::string>& warnings) {
  const std::int64_t steps = last_step(scene);
  if (rock_dissolves(scene) || scene.damage)
    held.push_back(
        {"update_interval", scene.accuracy.update_interval, "no node dissolves and no pathway opens", nullptr});
  for (const Held& one : held)
    if (one.interval > steps)
      warnings.push_back(fmt::format("accuracy.{} = {} is more than the whole run, {} steps: {} in it", one.key,
                                     one.interval, steps, one.never));
}

void warn_of_old_rows(const Scene& scene, const std::vector<Held>& held, std::vector<std::string>& warnings) {
  const OutputSection& output = scene.output;
  const char* const snapshots = output.interval_steps ? "interval_steps" : "interval";
  const double rows = history_interval(scene), least = std::min(rows, output_interval(scene));
  const char* const by = least == rows ? "history_interval" : snapshots;
  const bool given = least == rows ? output.history_interval.has_value() : output.interval || output.interval_steps;
  const std::int64_t steps = last_step(scene);
  constexpr double rounding = 1e-6;
  for (const Held& one : held)
    if (one.old && one.interval > least + rounding && one.interval <= steps)  // longer ones are told of as such
      warnings.push_back(fmt::format(
          "output.{} is {:.3g} lattice steps{}, accuracy.{} {}: {} are shown as they were up to {} steps before; raise "
          "the one or lower the other",
          by, least, given ? "" : " by default", one.key, one.interval, one.old, one.interval - 1));
}

void warn_of_pulses(const Scene& scene, const std::vector<Held>& held, std::vector<std::string>& warnings) {
  const double shortest = quickest_flow(scene);
  if (!scene.flow) return;
  constexpr double rounding = 1e-9;
  for (const Held& one : held)
    if (const double time = one.interval * scene.lattice.time_step;
        shortest < time * (1 - rounding) && one.interval > 1)
      warnings.push_back(fmt::format(
          "a given flow changes within {:.3g} s, accuracy.{} is {:.3g} s ({} steps): {}, so pulses may be missed or "
          "count in full; lower it",
          shortest, one.key, time, one.interval,
          one.old ? "the velocity at one step of each interval carries for all of it"
                  : "the force at the first step of each interval acts for all of it"));
}

/// The first time (s) in the run at which a table has a value that neither of the lattice steps around it has, nor any
/// between the two, but for a hundredth of its range: a peak mostly lies between two steps.
std::optional<double> unseen_value(const TimeTable& table, const Scene& scene) {
  const double step = scene.lattice.time_step, end = static_cast<double>(last_step(scene)) * step;
  const double slack = 0.01 * (table.highest() - table.lowest());
  for (const double time : table.moments()) {
    if (time < 0 || time > end) continue;
    const double before = std::floor(time / step * (1 + 1e-12)) * step;
    const double here = table.at(before), next = table.at(before + step);
    const double low = std::min(here, next), high = std::max(here, next);
    if (const double value = table.at(time); value < low - slack || value > high + slack) return time;
  }
  return std::nullopt;
}

void warn_of_unseen_values(const Scene& scene, std::vector<std::string>& warnings) {
  std::optional<double> first;
  const auto look = [&](const TimeTable& table) {
    if (!first) first = unseen_value(table, scene);
  };
  for_each_boundary(scene, [&](const BoundarySection& given) {
    if (scene.flow) given.flow.for_each_table(look);
    if (scene.heat) look(given.heat.temperature);
    if (scene.heat) look(given.heat.flux);
    if (scene.solute)
      for (const auto* tables : {&given.solute.concentration, &given.solute.flux})
        for (const auto& [species, table] : *tables) look(table);
  });
  if (first)
    warnings.push_back(fmt::format(
        "a table over time has a value at {:.6g} s that neither of the lattice steps around it has: each takes "
        "the value at its beginning, so that a pulse shorter than lattice.time_step = {:g} s counts in part, "
        "not at all or in full",
        *first, scene.lattice.time_step));
}

void warn_of_rare_looks(const Scene& scene, std::vector<std::string>& warnings) {
  constexpr int rare = 1000;
  const AccuracySection& accuracy = scene.accuracy;
  const int look = look_interval(accuracy), longer = std::max(accuracy.update_interval, accuracy.solute_interval);
  if (accuracy.dissolution_tolerance == 0 || look <= rare) return;
  const bool common = longer % std::min(accuracy.update_interval, accuracy.solute_interval) != 0;
  warnings.push_back(fmt::format(
      "accuracy.dissolution_tolerance: how much faster the rock may age is looked at every {} lattice steps only, for "
      "accuracy.update_interval = {} and solute_interval = {}; {}",
      look, accuracy.update_interval, accuracy.solute_interval,
      common ? "let one of them be a multiple of the other" : "lower them"));
}

}  // namespace

double quickest_flow(const Scene& scene) {
  double shortest = std::numeric_limits<double>::infinity();
  for_each_boundary(scene, [&](const BoundarySection& given) {
    given.flow.for_each_table([&](const TimeTable& table) { shortest = std::min(shortest, table.quickest()); });
    if (given.flow.ramp_time > 0) shortest = std::min(shortest, given.flow.ramp_time);
  });
  return shortest;
}

std::vector<std::string> interval_warnings(const Scene& scene) {
  std::vector<std::string> warnings;
  if (!scene.laboratory) warn_of_unseen_values(scene, warnings);
  if (scene.laboratory || scene.accuracy.chooses_intervals()) return warnings;
  const std::vector<Held> held = held_by(scene);
  warn_of_short_run(scene, held, warnings);
  warn_of_old_rows(scene, held, warnings);
  warn_of_pulses(scene, held, warnings);
  warn_of_rare_looks(scene, warnings);
  return warnings;
}

}  // namespace vug
