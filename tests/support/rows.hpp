#pragma once
// The history of a case in memory.
#include "coupling/simulation.hpp"
#include "io/history_reader.hpp"

#include <vector>

namespace vug::test {

/// Rows at the start and after every `every` steps, up to `steps`.
inline History rows_of(const Scene& scene, int steps, int every) {
  Simulation simulation(scene);
  simulation.begin();
  History history;
  for (int step = 0;; ++step) {
    if (step % every == 0) {
      const std::vector<HistoryValue> row = simulation.history();
      if (step == 0) history.values.resize(row.size());
      for (std::size_t c = 0; c < row.size(); ++c) {
        if (step == 0) history.names.push_back(row[c].name);
        history.values[c].push_back(row[c].value);
      }
    }
    if (step == steps) return history;
    simulation.step();
  }
}

}  // namespace vug::test
