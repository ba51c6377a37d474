#pragma once
// Runs a scene and writes its run directory: steps, guards, snapshots, history, origin.
#include "io/scene.hpp"
#include "ranks/ranks.hpp"

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

namespace vug {

/// Options of the command line.
struct RunOptions {
  std::string directory;
  std::optional<std::int64_t> steps;  ///< stop after this many lattice steps, independent of the case
  bool resume = false;     ///< continue from the newest checkpoint in `directory`, or begin where there is none
  bool overwrite = false;  ///< replace the run in `directory`
  bool terminal = false;   ///< progress is shown on a terminal
  std::ostream* progress = nullptr;  ///< null: quiet
  std::ostream* warnings = nullptr;  ///< for warnings of a quiet run; null: nowhere
  /// The message of a signal that arrives when the run is done and the process has not ended yet.
  const char* words_when_done = "interrupted when the run was done";
  Ranks ranks{};  ///< the processes that compute the case together; the first one writes
};

/// Runs the scene. Throws InputError, StabilityError (run.json names the last good checkpoint), FileError, or
/// Interrupted (host/interruption.hpp) after the state has been saved in a checkpoint; in a lattice step that takes
/// more than some seconds longer (100 000 mechanical steps), without a new one.
void run_case(const Scene& scene, const RunOptions& options);

}  // namespace vug
