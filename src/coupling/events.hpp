#pragma once
// What has happened in the rock: lines for the log and for run.json.
#include "coupling/simulation.hpp"

#include <map>
#include <string>
#include <vector>

namespace vug {

/// Watches counts that only grow and tells when each reaches 1, 10, 100, ...: failed bonds, dissolved nodes, nodes that
/// damage has opened; and breakthrough, when a species leaves through an outflow with 1 % of what was injected of it;
/// and that rock has grown on the whole.
class Events {
 public:
  /// What has happened before is no news; `earlier` is what has been told of it.
  explicit Events(const Simulation& simulation, const std::vector<std::string>& earlier = {});

  /// News of the counts, one line each; copies the states of the bonds to the host.
  std::vector<std::string> look(const Simulation& simulation);
  /// What is to be said of how the run began: that the preload did not come to rest.
  static std::vector<std::string> of_the_start(const Simulation& simulation);
  /// What is to be said at the end: how far the rock has aged beyond the fluid, and what that has cost.
  static std::vector<std::string> sum_up(const Simulation& simulation);
  /// News of a row of the history, which is dear to compute: breakthrough, growth.
  std::vector<std::string> look_at_row(const Simulation& simulation, const std::vector<HistoryValue>& row);

 private:
  std::map<std::string, std::int64_t> next_;  ///< count at which each thing is told next
  bool begun_ = false;
};

}  // namespace vug
