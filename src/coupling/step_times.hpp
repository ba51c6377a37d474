#pragma once
// The times at which a step of several lattice steps evaluates tables over time.
#include "coupling/clock.hpp"

namespace vug {

/// The beginnings (s) of the lattice steps that a step of heat or solutes spans: `count` of them up to `last`. Tables
/// are evaluated at each of them, so that a pulse counts exactly once however short it is.
struct StepTimes {
  double last = 0;
  double time_step = 0;
  int count = 1;

  /// Mean of value(time) over them. One step with the mean of a table of fluxes takes in as much as `count` steps of
  /// one lattice step each.
  template <class Value>
  double mean(const Value& value) const {
    return mean_up_to(last, value);
  }
  /// Mean over as many times around the last one. A value given at a wall acts at the end of the step, not in its
  /// middle, so that with the mean of the times before it would be late by half a step.
  template <class Value>
  double mean_about_last(const Value& value) const {
    return mean_up_to(last + 0.5 * (count - 1) * time_step, value);
  }

 private:
  template <class Value>
  double mean_up_to(double end, const Value& value) const {
    double sum = 0;
    for (int before = count - 1; before >= 0; --before) sum += value(end - before * time_step);
    return sum / count;
  }
};

/// Times of the next step of `count` lattice steps, which ends when the number of lattice steps done is a multiple of
/// `count` (Clock::every).
inline StepTimes next_step(const Clock& clock, int count) {
  const std::int64_t steps_to_go = count - 1 - clock.step % count;
  return {clock.time() + static_cast<double>(steps_to_go) * clock.time_step, clock.time_step, count};
}

}  // namespace vug
