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

/// A peak or trough of a table over time, above the higher of the points around it.
struct Pulse {
  double time;   ///< of its first point, s
  double begin;  ///< s
  double end;
  double area;   ///< height times s, positive
  double taken;  ///< the sum of that at lattice steps, times a step
};

/// That of the points first ... last of a table, which have one value.
Pulse pulse_at(const TimeTable& table, std::size_t first, std::size_t last, double step) {
  const std::vector<double>& time = table.moments();
  const double top = table.at(time[first]), before = table.at(time[first - 1]), after = table.at(time[last + 1]);
  const double height = top > before ? top - std::max(before, after) : std::min(before, after) - top;
  const double rise = (time[first] - time[first - 1]) * height / std::abs(top - before);
  const double fall = (time[last + 1] - time[last]) * height / std::abs(top - after);
  Pulse pulse{time[first], time[first] - rise, time[last] + fall, 0, 0};
  pulse.area = height * (time[last] - time[first] + (rise + fall) / 2);
  if (pulse.end - pulse.begin > 100 * step) return pulse;
  for (double k = std::ceil(pulse.begin / step); k * step <= pulse.end; ++k)
    pulse.taken += step * std::max(0.0, height - std::abs(top - table.at(k * step)));
  return pulse;
}

/// The first pulse in the run of which lattice steps take a tenth less or more than there is, but for the smallest.
std::optional<Pulse> mistaken_pulse(const TimeTable& table, const Scene& scene) {
  const double step = scene.lattice.time_step, end = static_cast<double>(last_step(scene)) * step;
  const std::vector<double>& time = table.moments();
  for (std::size_t first = 1; first + 1 < time.size() && time[first] <= end; ++first) {
    std::size_t last = first;
    const double before = table.at(time[first - 1]), top = table.at(time[first]);
    while (last + 1 < time.size() && table.at(time[last + 1]) == top) ++last;
    if (top == before || last + 1 == time.size()) continue;
    if ((top > before) != (top > table.at(time[last + 1]))) continue;
    const Pulse pulse = pulse_at(table, first, last, step);
    const double smallest = 0.01 * step * table.farthest(table.at(time.front()), pulse.time);
    if (pulse.begin >= 0 && pulse.end - pulse.begin <= 100 * step && std::max(pulse.area, pulse.taken) > smallest &&
        std::abs(pulse.taken - pulse.area) > 0.1 * pulse.area)
      return pulse;
  }
  return std::nullopt;
}

void warn_of_mistaken_pulses(const Scene& scene, std::vector<std::string>& warnings) {
  std::optional<Pulse> first;
  const auto look = [&](const TimeTable& table) {
    if (!first) first = mistaken_pulse(table, scene);
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
        "a table over time has a pulse of {:.2g} s at {:.6g} s of which lattice steps take {:.2g} times as much as "
        "there "
        "is: each takes the value at its beginning; lower lattice.time_step = {:g} s, or give a longer and lower pulse",
        first->end - first->begin, first->time, first->taken / first->area, scene.lattice.time_step));
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
  if (!scene.laboratory) warn_of_mistaken_pulses(scene, warnings);
  if (scene.laboratory || scene.accuracy.chooses_intervals()) return warnings;
  const std::vector<Held> held = held_by(scene);
  warn_of_short_run(scene, held, warnings);
  warn_of_old_rows(scene, held, warnings);
  warn_of_pulses(scene, held, warnings);
  warn_of_rare_looks(scene, warnings);
  return warnings;
}

}  // namespace vug
