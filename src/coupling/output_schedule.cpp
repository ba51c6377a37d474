#include "coupling/output_schedule.hpp"

#include <algorithm>

namespace vug {

namespace {

constexpr std::int64_t rows = 400;  // of a history, about, where the case does not say

double steps_in(double seconds, const Scene& scene) {
  return std::max(1.0, seconds / scene.lattice.time_step);
}

/// The schedule for an interval in steps or, where the rock ages by more than the steps
/// (accuracy.dissolution_tolerance), in seconds.
Schedule schedule(const Scene& scene, double steps, std::optional<double> seconds) {
  return {steps, scene.accuracy.dissolution_tolerance > 0 ? seconds.value_or(0) : 0};
}

}  // namespace

std::int64_t last_step(const Scene& scene) {
  if (scene.time.steps) return *scene.time.steps;
  return static_cast<std::int64_t>(std::ceil(*scene.time.end / scene.lattice.time_step - 1e-6));
}

double output_interval(const Scene& scene) {
  if (scene.output.interval_steps) return static_cast<double>(*scene.output.interval_steps);
  if (scene.output.interval) return steps_in(*scene.output.interval, scene);
  return static_cast<double>(std::max<std::int64_t>(1, last_step(scene)));
}

double history_interval(const Scene& scene) {
  constexpr std::int64_t fewest_steps = 100;  // which cost very little
  if (scene.output.history_interval) return steps_in(*scene.output.history_interval, scene);
  return static_cast<double>(std::max(fewest_steps, last_step(scene) / rows));
}

double row_interval(const Scene& scene) {
  if (scene.output.history_interval) return *scene.output.history_interval;
  if (scene.accuracy.dissolution_tolerance > 0 && scene.time.end) return *scene.time.end / rows;
  return history_interval(scene) * scene.lattice.time_step;
}

Schedule output_schedule(const Scene& scene) {
  std::optional<double> seconds = scene.output.interval;
  if (!seconds && !scene.output.interval_steps) seconds = scene.time.end;
  return schedule(scene, output_interval(scene), seconds);
}

Schedule row_schedule(const Scene& scene) {
  std::optional<double> seconds = scene.output.history_interval;
  if (!seconds && scene.time.end) seconds = *scene.time.end / rows;
  return schedule(scene, history_interval(scene), seconds);
}

Schedule checkpoint_schedule(const Scene& scene) {
  const std::optional<double>& seconds = scene.output.checkpoint_interval;
  return seconds ? schedule(scene, steps_in(*seconds, scene), seconds) : output_schedule(scene);
}

}  // namespace vug
