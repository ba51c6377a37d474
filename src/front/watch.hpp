#pragma once
// `vug watch`: progress of a run, in a terminal.
#include "io/history_reader.hpp"
#include "io/run_folder.hpp"
#include "io/run_summary.hpp"

#include <functional>
#include <string>
#include <vector>

namespace vug {

/// State of a run, to be drawn.
struct WatchedRun {
  RunSummary summary;
  History history;             ///< empty before the first row
  InUse in_use = InUse::yes;   ///< whether a process writes into the folder
  double seconds = 0;          ///< since the run began or was resumed
  std::string doubt;           ///< why it cannot be determined whether a process writes
  double since_last_row = -1;  ///< s; below 0 before the first row

  bool under_way() const { return summary.status == "running" && in_use != InUse::no; }
};

/// Settings of the drawing.
struct WatchView {
  int width = 80, height = 24;       ///< of the terminal, characters
  std::vector<std::string> columns;  ///< of history.csv; empty: those that change, as many as fit
};

/// Draws `values` over `time` as `width` blocks of eight heights, from the first moment to the last.
std::string sparkline(const std::vector<double>& time, const std::vector<double>& values, int width);

/// Text with state and progress of the run, a line per column (name, curve, last value) and the largest balance error.
/// Throws InputError for a column that the history does not have.
std::string watch_text(const WatchedRun& run, const WatchView& view);

/// Reads `directory` and passes its text to `show`, every second until no process writes there any more, or only once.
/// Returns whether the run is done or, as far as can be determined, still running. Throws InputError where there is no
/// run, FileError.
bool watch(const std::string& directory, const WatchView& view, bool once,
           const std::function<void(const std::string&)>& show);

}  // namespace vug
