#pragma once
// Chooses intervals during a run (accuracy.tolerance).
#include "coupling/clock.hpp"
#include "coupling/given_changes.hpp"
#include "coupling/history_value.hpp"
#include "coupling/intervals.hpp"
#include "io/field_list.hpp"
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

/// The longest intervals that a case allows: powers of two up to the values of its own keys.
Intervals longest_intervals(const AccuracySection& accuracy);

/// Chooses intervals from how fast things change. What is held lags by half an interval in the mean, and what reacts is
/// booked ahead by as much. Within an interval of the solutes, nothing of them may therefore change by more than the
/// tolerance as a share of itself, and no interval is longer than that share of the time so far. Other intervals cost
/// less per share (docs/model.md): heat and force may change by four times as much, and what waits for the next look at
/// the rock by eight times. Normals and rates of walls are set for the middle of their interval, so that the error is
/// the square of the share. The intervals are the same for any number of threads and ranks.
class IntervalChooser {
 public:
  /// Lattice steps between looks.
  static constexpr int look_interval = 128;

  /// `most`: the longest intervals that are wanted, and stable in a fluid at rest; `safe`: those that are stable at the
  /// largest speed that the case can drive.
  IntervalChooser(const Scene& scene, const Intervals& most, const Intervals& safe);

  const Intervals& now() const { return now_; }
  const Intervals& most() const { return most_; }
  /// Whether a look is due before the step that follows.
  bool due(const Clock& clock) const { return clock.every(look_interval); }
  /// Chooses from what has changed since the last look and from what given values do until the next, at most `stable`.
  /// Returns whether an interval has changed.
  bool choose(Changes changes, const Intervals& stable, const Clock& clock);
  /// To be called when a pathway has opened, through which fluid may move fast: intervals are limited to `safe` until
  /// looks have seen its speed.
  void be_wary() { wary_looks_ = 2; }
  /// Shortens steps of heat or solutes that are longer than `safe`, where the step that follows ends both. Returns
  /// whether it did.
  bool shorten(const Clock& clock);
  /// A line for every look that has changed intervals, since the program started.
  const std::vector<std::string>& news() const { return news_; }
  void history(std::vector<HistoryValue>& row) const;
  void state(StateList& list);

 private:
  // a name for the type, because nvcc writes such a member with parentheses, of which GCC warns
  using Interval = int Intervals::*;

  struct Rule {
    const char* name;
    Interval interval;
    bool there;                        ///< the scene has what the interval holds
    double allowed;                    ///< share by which that may change in an interval
    double (*change)(const Changes&);  ///< share by which it has changed since the last look
  };

  /// Takes over new intervals and notes those that have changed. Returns whether any has.
  bool go_on_with(const Intervals& next, const Clock& clock);

  GivenChanges given_;
  std::vector<Rule> rules_;
  Intervals most_, safe_, now_;
  int wary_looks_ = 0;
  std::vector<std::string> news_;
};

}  // namespace vug
