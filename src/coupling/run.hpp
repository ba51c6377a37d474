#pragma once
// A run from its scene to its run directory: steps, guards, snapshots, history, provenance.
#include "io/scene.hpp"
#include "ranks/ranks.hpp"

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

namespace vug {

/// What the command line adds to a scene.
struct RunOptions {
  std::string directory;
  std::optional<std::int64_t> steps;  ///< stop after this many lattice steps, whatever the case says
  bool resume = false;     ///< continue from the newest checkpoint in `directory`, or begin where there is none
  bool overwrite = false;  ///< replace the run that `directory` holds
  bool terminal = false;   ///< the progress goes to a terminal
  std::ostream* progress = nullptr;  ///< null: quiet
  std::ostream* warnings = nullptr;  ///< where warnings go of a quiet run; null: nowhere
  /// What a signal says that comes when the run is done and the process has not ended yet.
  const char* words_when_done = "interrupted when the run was done";
  Ranks ranks{};  ///< who computes the case together; the first of them writes
};

/// Runs the scene. Throws InputError, StabilityError (run.json names the last good checkpoint), FileError, or
/// Interrupted (host/interruption.hpp) when the state has been kept in a checkpoint.
void run_case(const Scene& scene, const RunOptions& options);

}  // namespace vug
