#pragma once
// Whether fixed steps of heat and solutes are short enough for the speed that the fluid turns out to have.
#include "coupling/clock.hpp"
#include "coupling/history_value.hpp"
#include "io/scene.hpp"

#include <string>
#include <vector>

namespace vug {

/// The steps of something that the fluid carries.
struct CarriedStep {
  const char* key;     ///< of [accuracy]
  int interval;        ///< lattice steps
  double longest_way;  ///< cells that it may be carried in one of its steps (docs/stability.md)
  /// Cells that it is carried in a step at a speed (lattice units) of the fluid.
  double way(double speed) const { return interval * speed; }
  /// The longest interval of at least a lattice step that holds at this speed; 0: none does.
  int longest_at(double speed) const;
};

/// Those of a case, none where a tolerance chooses the intervals, which then follow the speed.
std::vector<CarriedStep> carried_steps(const Scene& scene);

/// Watches the largest speed in the rows of a history, and warns once of each interval that it makes too long: the
/// intervals were chosen before the run, for a speed that could only be estimated.
class CarriedSteps {
 public:
  /// `earlier`: lines that the run has told before it was resumed.
  CarriedSteps(const Scene& scene, const std::vector<std::string>& earlier);
  /// New warnings, one line each.
  std::vector<std::string> look_at_row(const Clock& clock, const std::vector<HistoryValue>& row);

 private:
  std::vector<CarriedStep> steps_;  ///< of which nothing has been said
};

}  // namespace vug
