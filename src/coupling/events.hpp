#pragma once
// Events in the rock, as lines for the log and for run.json.
#include "coupling/simulation.hpp"

#include <map>
#include <string>
#include <vector>

namespace vug {

/// Watches counts that only grow and reports when each reaches 1, 10, 100, ...: failed bonds, dissolved nodes, nodes
/// opened by damage. Also reports breakthrough, when more than 1 % of the injected amount of a species has left, that
/// rock has grown on the whole, and that the limiter of the speed is at work.
class Events {
 public:
  /// Earlier events are not reported again; `earlier` has the lines about them.
  explicit Events(const Simulation& simulation, const std::vector<std::string>& earlier = {});

  /// New lines about the counts; copies the states of the bonds to the host.
  std::vector<std::string> look(const Simulation& simulation);
  /// Line about the start of the run, if the preload did not come to rest.
  static std::vector<std::string> of_the_start(const Simulation& simulation);
  /// Lines at the end: how often the speed was limited up to the last row; how much the rock has aged beyond the fluid,
  /// and what error that has caused.
  std::vector<std::string> sum_up(const Simulation& simulation) const;
  /// New lines from a row of the history, which is expensive to compute: breakthrough, growth, limited speeds.
  std::vector<std::string> look_at_row(const Simulation& simulation, const std::vector<HistoryValue>& row);

 private:
  std::map<std::string, std::int64_t> next_;  ///< count at which each event is reported next
  bool begun_ = false;
  double limited_ = 0, limited_share_ = 0;  ///< uses of the limiter up to the last row; per node and step
};

}  // namespace vug
