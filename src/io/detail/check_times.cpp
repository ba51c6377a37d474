// Checks of the end of a run and of its intervals.
#include "io/detail/case_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace vug {

namespace {

/// An interval that the case itself gives must end in the run, or what it is for never happens. Those of a preset are
/// warned of instead (interval_warnings.hpp), as is a run without a look at the rock.
void check_held(const TomlDocument& document, const Scene& scene) {
  const AccuracySection& accuracy = scene.accuracy;
  if (accuracy.chooses_intervals()) return;  // then it is the longest that may be chosen
  const double steps = scene.time.end ? std::ceil(*scene.time.end / scene.lattice.time_step - 1e-6)
                                      : static_cast<double>(*scene.time.steps);
  const auto check = [&](bool there, const char* key, int interval, const char* never) {
    if (there && interval > steps && document.find(key))
      document.fail(key, fmt::format("is more than the whole run, {:.0f} steps: {}", steps, never));
  };
  check(scene.heat.has_value(), "accuracy.heat_interval", accuracy.heat_interval, "no temperature would change");
  check(scene.solute.has_value(), "accuracy.solute_interval", accuracy.solute_interval,
        "no concentration would change");
  check(scene.flow && scene.mechanics, "accuracy.exchange_interval", accuracy.exchange_interval,
        "the rock would bear the force that the fluid has at the start");
}

}  // namespace

void check_times(const TomlDocument& document, const Scene& scene) {
  const double step = scene.lattice.time_step;
  const double slack = 1e-9 * step;
  if (scene.time.end && *scene.time.end < step - slack) {
    document.fail("time.end", fmt::format("is shorter than one lattice.time_step = {:g} s", step));
  }
  if (scene.time.end && *scene.time.end / step > 1e15) {
    document.fail("time.end", fmt::format("is more than 1e15 steps of lattice.time_step = {:g} s", step));
  }
  const bool ages = scene.accuracy.dissolution_tolerance > 0;  // then the number of steps does not determine the time
  const double end = scene.time.end ? *scene.time.end
                     : ages         ? std::numeric_limits<double>::max()
                                    : static_cast<double>(*scene.time.steps) * step;
  const auto check_interval = [&](const char* key, const std::optional<double>& interval) {
    if (!interval) return;
    if (*interval < step - slack)
      document.fail(key, fmt::format("is shorter than one lattice.time_step = {:g} s", step));
    if (*interval > end + slack)
      document.fail(key, fmt::format("is longer than the whole run, {:g} s (vug run --steps N ends it earlier)", end));
  };
  check_interval("output.interval", scene.output.interval);
  check_interval("output.history_interval", scene.output.history_interval);
  check_interval("output.checkpoint_interval", scene.output.checkpoint_interval);
  if (scene.output.interval_steps && static_cast<double>(*scene.output.interval_steps) * step > end + slack) {
    document.fail("output.interval_steps", fmt::format("is more than the whole run, {:.0f} steps", end / step));
  }
  check_held(document, scene);
}

}  // namespace vug
