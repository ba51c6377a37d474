#pragma once
// How fast the given values of boundaries change, which no look at the fields can foresee.
#include "coupling/clock.hpp"
#include "coupling/intervals.hpp"
#include "io/scene.hpp"

#include <vector>

namespace vug {

/// The largest |slope| of a table between `from` and `to` (s), in its unit per s.
double steepest(const TimeTable& table, double from, double to);

/// The tables over time at sides, injections and shapes. A table v is measured by its largest distance from the state
/// at rest so far: max |v - v_rest| up to its next point, where v_rest is the initial temperature or pressure of the
/// case and else 0. What a table does later, perhaps after the end of the run, hides no change of now.
class GivenChanges {
 public:
  explicit GivenChanges(const Scene& scene);
  /// Raises each share of `changes` to that by which a table that acts on it changes in `steps` lattice steps where it
  /// is steepest between now and then: max |dv/dt| steps dt / max |v - v_rest|. A table of the flow acts on all that
  /// the flow carries or pushes. Ramps are over before an interval may be as long as they are.
  void raise(Changes& changes, const Clock& clock, int steps) const;

 private:
  struct Given {
    TimeTable table;
    double rest;  ///< in its own unit
    std::vector<double Changes::*> acts_on;
  };
  std::vector<Given> tables_;  ///< those that change
};

}  // namespace vug
