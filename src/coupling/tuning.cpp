#include "coupling/tuning.hpp"

#include "base/require.hpp"
#include "coupling/history_difference.hpp"
#include "coupling/interval_chooser.hpp"
#include "coupling/output_schedule.hpp"
#include "coupling/simulation.hpp"
#include "host/interruption.hpp"
#include "host/work_time.hpp"
#include "io/override_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <ostream>

namespace vug {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Stands for the rung of a setting that stays as the case has it.
constexpr std::size_t as_in_case = std::numeric_limits<std::size_t>::max();

/// Rows of a pilot's history are at steps where every interval of settings_of has just ended.
constexpr std::int64_t steps_of_a_row = 40;
constexpr std::int64_t rows_of_a_pilot = 20;

std::int64_t steps_of_a_pilot(const Scene& scene, const TuningOptions& options) {
  const std::int64_t all = last_step(scene);
  const std::int64_t wanted = options.steps.value_or(std::clamp<std::int64_t>(all / 20, 800, 8000));
  return std::max<std::int64_t>(1, std::min(wanted, all));
}

/// Lattice steps after which all intervals of a case that delay what rows show have just ended. Where a pilot of
/// `steps` is too short for those of forces and pores as well, those of heat and solutes; where for these too,
/// steps_of_a_row.
std::int64_t common_interval(const Scene& scene, std::int64_t steps) {
  const AccuracySection& given = scene.accuracy;
  const Intervals all = given.chooses_intervals()
                            ? longest_intervals(given)
                            : Intervals{given.heat_interval, given.solute_interval, given.wall_interval,
                                        given.exchange_interval, given.update_interval};
  std::int64_t common = 1;
  if (scene.heat) common = std::lcm(common, all.heat);
  if (scene.solute) common = std::lcm(common, all.solute);
  const std::int64_t shown = common;
  if (scene.mechanics && scene.flow) common = std::lcm(common, all.exchange);
  if (scene.reaction || scene.mechanics) common = std::lcm(common, all.update);
  constexpr int fewest_rows = 4;
  return common * fewest_rows <= steps ? common : shown <= steps ? shown : steps_of_a_row;
}

struct Pilot {
  History history;
  double cost = 0;  ///< time of its steps, s: processor time, on a GPU by the clock
};

void add_row(const std::vector<HistoryValue>& row, History& history) {
  if (history.names.empty()) {
    for (const HistoryValue& value : row) history.names.push_back(value.name);
    history.values.resize(row.size());
  }
  for (std::size_t c = 0; c < row.size(); ++c) history.values[c].push_back(row[c].value);
}

/// The steps of a pilot between two rows: about a twentieth of its steps, a multiple of `unit`, where it has as many.
std::int64_t row_of(std::int64_t steps, std::int64_t unit) {
  const std::int64_t rows = std::max<std::int64_t>(1, std::min(rows_of_a_pilot, steps / unit));
  return std::max<std::int64_t>(1, steps / rows / unit * unit);
}

/// Runs the first `steps` of a scene, with a row every `row` of them and one of the last. Throws StabilityError where
/// they are unstable.
Pilot fly(const Scene& scene, std::int64_t steps, std::int64_t row) {
  Simulation simulation(scene);
  Pilot pilot;
  simulation.begin();
  add_row(simulation.history(), pilot.history);
  double start = work_seconds();
  for (std::int64_t step = 1; step <= steps; ++step) {
    simulation.step();
    if (step % scene.accuracy.guard_interval == 0 || step == steps) simulation.guard();
    throw_if_stop_requested();
    if (step % row != 0 && step != steps) continue;
    simulation.catch_up();
    pilot.cost += work_seconds() - start;
    add_row(simulation.history(), pilot.history);
    start = work_seconds();
  }
  return pilot;
}

/// Pilots of one scene, compared with the one that has the first rung of every setting.
class Pilots {
 public:
  Pilots(const Scene& scene, const TuningOptions& options)
      : scene_(scene),
        options_(options),
        settings_(settings_of(scene)),
        steps_(steps_of_a_pilot(scene, options)),
        sound_(speed_of_sound(scene.lattice)) {
    reference_ = fly(finest(), steps_, row_of(steps_, steps_of_a_row));
    ++count_;
    largest_difference(reference_.history, reference_.history, options_.columns,
                       sound_);  // throws for an unknown column
  }

  /// The difference for the case as it is, at rows where its own intervals have just ended.
  Difference as_it_is(double& cost) {
    const std::int64_t own = common_interval(scene_, steps_);
    if (steps_of_a_row % own == 0) return of(scene_, reference_, steps_, row_of(steps_, steps_of_a_row), cost);
    const std::int64_t row = row_of(steps_, own), steps = steps_ / row * row;
    ++count_;
    return of(scene_, fly(finest(), steps, row), steps, row, cost);
  }

  /// The difference with these rungs.
  Difference operator()(const std::vector<std::size_t>& rungs, double& cost) {
    return of(scene_of(rungs), reference_, steps_, row_of(steps_, steps_of_a_row), cost);
  }

  const std::vector<Setting>& settings() const { return settings_; }
  std::int64_t steps() const { return steps_; }
  int count() const { return count_; }

 private:
  Difference of(const Scene& scene, const Pilot& reference, std::int64_t steps, std::int64_t row, double& cost) {
    ++count_;
    try {
      const Pilot pilot = fly(scene, steps, row);
      cost = pilot.cost / reference.cost;
      return largest_difference(reference.history, pilot.history, options_.columns, sound_);
    } catch (const StabilityError&) {
      return {infinite, ""};
    } catch (const InputError&) {  // an interval that is too long for this lattice
      return {infinite, ""};
    }
  }

  Scene finest() const { return scene_of(std::vector<std::size_t>(settings_.size(), 0)); }

  Scene scene_of(const std::vector<std::size_t>& rungs) const {
    std::vector<std::string> overrides;
    if (scene_.accuracy.tolerance > 0) overrides.push_back("accuracy.tolerance=0");  // rungs are no longest intervals
    for (std::size_t s = 0; s < settings_.size(); ++s)
      if (rungs[s] != as_in_case) overrides.push_back(settings_[s].key + "=" + settings_[s].rungs[rungs[s]]);
    return override_scene(scene_, overrides);
  }

  const Scene& scene_;
  const TuningOptions& options_;
  std::vector<Setting> settings_;
  std::int64_t steps_;
  double sound_;  ///< m/s
  Pilot reference_;
  int count_ = 0;
};

/// The highest rung of setting `s` whose error alone is at most `allowed`.
TunedSetting climb(Pilots& pilots, std::size_t s, double allowed, const TuningOptions& options) {
  TunedSetting tuned{pilots.settings()[s]};
  std::vector<std::size_t> rungs(pilots.settings().size(), 0);
  while (tuned.chosen + 1 < tuned.setting.rungs.size()) {
    rungs[s] = tuned.chosen + 1;
    double cost = 0;
    const Difference difference = pilots(rungs, cost);
    if (options.progress)
      *options.progress << fmt::format("{} = {}: {:.1e} {}\n", tuned.setting.key, tuned.setting.rungs[rungs[s]],
                                       difference.value, difference.column);
    tuned.seen = difference.value > 0;
    if (!tuned.seen || !(difference.value <= allowed)) break;
    tuned.chosen = rungs[s];
    tuned.errors.push_back(difference.value);
  }
  return tuned;
}

}  // namespace

std::vector<Setting> settings_of(const Scene& scene) {
  std::vector<Setting> settings;
  const auto add = [&](bool matters, const char* key, std::vector<std::string> rungs) {
    if (matters) settings.push_back({key, std::move(rungs)});
  };
  const bool rock = scene.mechanics.has_value(), pores = scene.reaction || scene.damage;
  add(true, "accuracy.precision", {"\"double\"", "\"single\""});
  add(scene.heat.has_value(), "accuracy.heat_interval", {"1", "2", "4", "8"});
  add(scene.solute.has_value(), "accuracy.solute_interval", {"1", "2", "4", "8"});
  add(pores, "accuracy.update_interval", {"1", "5", "10", "20", "40"});
  add(scene.reaction.has_value(), "accuracy.wall_interval", {"1", "10", "50", "100", "400"});
  add(rock && scene.flow, "accuracy.exchange_interval", {"1", "2", "4", "8"});
  add(rock && !scene.mechanics->substeps, "mechanics.critical_fraction", {"0.3", "0.5"});
  add(rock, "mechanics.mass_scaling", {"1", "4", "16"});
  add(rock, "mechanics.rest_tolerance", {"0", "2e-3", "5e-3", "1e-2"});
  return settings;
}

Tuning tune(const Scene& given, const TuningOptions& options) {
  const StopsInOrder in_order;
  const bool ages = given.accuracy.dissolution_tolerance > 0;  // pilots of as many steps would not be as long
  const Scene scene = ages ? override_scene(given, {"accuracy.dissolution_tolerance=0"}) : given;
  Pilots pilots(scene, options);
  Tuning tuning;
  tuning.steps = pilots.steps();
  tuning.error_of_case = pilots.as_it_is(tuning.cost_of_case).value;
  std::vector<std::size_t> rungs;
  for (std::size_t s = 0; s < pilots.settings().size(); ++s) {
    tuning.settings.push_back(climb(pilots, s, options.tolerance / 2, options));
    rungs.push_back(tuning.settings.back().seen ? tuning.settings.back().chosen : as_in_case);
  }
  while (true) {
    const Difference together = pilots(rungs, tuning.cost);
    tuning.error = together.value;
    tuning.worst = together.column;
    if (options.progress) *options.progress << fmt::format("together: {:.1e}\n", together.value);
    if (together.value <= options.tolerance) break;
    const auto costliest =
        std::max_element(tuning.settings.begin(), tuning.settings.end(),
                         [](const TunedSetting& a, const TunedSetting& b) { return a.error() < b.error(); });
    if (costliest == tuning.settings.end() || costliest->chosen == 0) break;
    rungs[static_cast<std::size_t>(costliest - tuning.settings.begin())] = --costliest->chosen;
  }
  tuning.pilots = pilots.count();
  return tuning;
}

std::string to_text(const Tuning& tuning, double tolerance) {
  std::string text =
      fmt::format("{} pilots of {} steps; errors over the largest change since the start\n\n{:<30} {:>8} {:>12}\n",
                  tuning.pilots, tuning.steps, "setting", "chosen", "error alone");
  std::string lines, table;
  for (const TunedSetting& tuned : tuning.settings) {
    const std::string& key = tuned.setting.key;
    if (!tuned.seen) {
      text += fmt::format("{:<30} {:>8} {:>12}\n", key, "as it is", "no effect");
      continue;
    }
    const std::string& value = tuned.setting.rungs[tuned.chosen];
    text += fmt::format("{:<30} {:>8} {:>12.1e}\n", key, value, tuned.error());
    const std::size_t dot = key.find('.');
    if (key.substr(0, dot) != table) {
      table = key.substr(0, dot);
      lines += fmt::format("\n[{}]\n", table);
    }
    lines += fmt::format("{} = {}\n", key.substr(dot + 1), value);
  }
  const auto factor = [](double cost) { return cost > 0 ? fmt::format("{:.2f}", 1 / cost) : std::string("?"); };
  text +=
      fmt::format("\nall together: {:.1e} of {:.1e} allowed{}, {} times as fast as the finest settings\n", tuning.error,
                  tolerance, tuning.worst.empty() ? "" : " (" + tuning.worst + ")", factor(tuning.cost));
  text += std::isfinite(tuning.error_of_case) ? fmt::format("the case as it is: {:.1e}, {} times as fast\n",
                                                            tuning.error_of_case, factor(tuning.cost_of_case))
                                              : std::string("the case as it is does not hold\n");
  return text + lines;
}

}  // namespace vug
