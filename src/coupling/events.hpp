#pragma once
// Events in the rock, as lines for the log and for run.json.
#include "coupling/simulation.hpp"

#include <map>
#include <string>
#include <vector>

namespace vug {

/// Watches counts that only grow and reports when each reaches 1, 10, 100, ...: failed bonds, fragments let go,
/// dissolved nodes, nodes opened by damage. Also reports breakthrough, when more than 1 % of the injected amount of a
/// species has left that reactions do not make, that rock has grown on the whole, that the limiter of the speed is at
/// work, and the concerns of modules (concerns.hpp), each once.
class Events {
 public:
  /// Earlier events are not reported again; `earlier` has the lines about them. `reversible`: see runs_backwards.
  explicit Events(const Simulation& simulation, const std::vector<std::string>& earlier = {}, bool reversible = true);

  /// Whether a reaction of the case may run backwards: the cause that is reported where rock has grown.
  static bool runs_backwards(const Scene& scene);

  /// New lines about the counts; copies the states of the bonds to the host.
  std::vector<std::string> look(const Simulation& simulation);
  /// Lines about the start of the run, if the preload did not come to rest or broke or damaged bonds.
  static std::vector<std::string> of_the_start(const Simulation& simulation);
  /// Lines at the end: how often the speed was limited up to the last row; how much the rock has aged beyond the fluid,
  /// and what error that has caused.
  std::vector<std::string> sum_up(const Simulation& simulation) const;
  /// New lines from a row of the history, which is expensive to compute: breakthrough, growth, limited speeds.
  std::vector<std::string> look_at_row(const Simulation& simulation, const std::vector<HistoryValue>& row);

 private:
  /// New lines about what is wrong with the state of the modules.
  std::vector<std::string> look_at_concerns(const Simulation& simulation);

  std::map<std::string, std::int64_t> next_;  ///< count at which each event is reported next
  std::vector<std::string> earlier_;          ///< lines of the run that this one continues
  bool reversible_;
  bool begun_ = false;
  double limited_ = 0, limited_share_ = 0;  ///< uses of the limiter up to the last row; per node and step
};

}  // namespace vug
