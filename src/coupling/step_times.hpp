#pragma once
// When a step that takes several lattice steps looks at tables over time.
#include "coupling/clock.hpp"

namespace vug {

/// The beginnings of the lattice steps that a step of heat or solutes takes, s: `count` of them up to `last`. One looks
/// at its own, and several at as many times, so that a pulse counts once however short it is.
struct StepTimes {
  double last = 0;
  double time_step = 0;
  int count = 1;

  /// Mean of value(time) over them: what as many steps of one lattice step take in by a table of fluxes, one takes in.
  template <class Value>
  double mean(const Value& value) const {
    return mean_up_to(last, value);
  }
  /// Mean over as many about the last: a value given at a wall acts at the end of the step, not in its middle, so that
  /// the mean of what lies behind would be late by half a step.
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

/// Those of the next step that takes `count` lattice steps: the one that ends when as many are done, as Clock::every
/// says.
inline StepTimes next_step(const Clock& clock, int count) {
  const std::int64_t steps_to_go = count - 1 - clock.step % count;
  return {clock.time() + static_cast<double>(steps_to_go) * clock.time_step, clock.time_step, count};
}

}  // namespace vug
