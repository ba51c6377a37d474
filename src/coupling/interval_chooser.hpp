#pragma once
// Chooses the intervals of a run as it goes (accuracy.tolerance).
#include "coupling/module.hpp"

#include <string>
#include <vector>

namespace vug {

/// The longest intervals that a case allows: its own keys, powers of two below them.
Intervals longest_intervals(const AccuracySection& accuracy);

/// Chooses from how fast things change. What is held lags by half an interval in the mean, and what reacts is booked
/// ahead by as much: so within an interval of the solutes nothing of them changes by more than the tolerance's share of
/// itself, and no interval is longer than that share of the time gone by. Others cost less per share (docs/model.md):
/// heat and force may change by four times as much, what waits for the next look at the rock by eight times. Normals
/// and rates of walls are set for the middle of their interval, which leaves the square of the share. The same on any
/// number of threads and ranks.
class IntervalChooser {
 public:
  /// Lattice steps between looks.
  static constexpr int look_interval = 128;

  /// `most`: the longest that are wanted, and stable in a fluid at rest; `safe`: at the largest speed that the case can
  /// drive.
  IntervalChooser(const Scene& scene, const Intervals& most, const Intervals& safe);

  const Intervals& now() const { return now_; }
  const Intervals& most() const { return most_; }
  /// Whether to look before the step that follows.
  bool due(const Clock& clock) const { return clock.every(look_interval); }
  /// Chooses from what has changed since the last look, no more than `stable`; true where an interval is another then.
  bool choose(const Changes& changes, const Intervals& stable, const Clock& clock);
  /// A pathway has opened, and fluid may shoot through it: what is safe is enough until a look has seen how fast.
  void be_wary() { wary_looks_ = 2; }
  /// Whether steps of heat or solutes are longer than that; shortens them where the step that follows ends both.
  bool shorten(const Clock& clock);
  /// A line for every look at which intervals have changed, since the program began.
  const std::vector<std::string>& news() const { return news_; }
  void history(std::vector<HistoryValue>& row) const;
  void state(StateList& list);

 private:
  // a name, since nvcc writes a member of this type with parentheses, of which GCC warns
  using Interval = int Intervals::*;

  struct Rule {
    const char* name;
    Interval interval;
    bool there;                        ///< the scene has what it holds
    double allowed;                    ///< share by which that may change in an interval
    double (*change)(const Changes&);  ///< by which it has changed since the last look
  };

  /// Notes and takes over what is other than now.
  bool go_on_with(const Intervals& next, const Clock& clock);

  std::vector<Rule> rules_;
  Intervals most_, safe_, now_;
  int wary_looks_ = 0;
  std::vector<std::string> news_;
};

}  // namespace vug
