#pragma once
// run.json read back: what a run says of itself, and of where it comes from.
#include "io/run_record.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// What a folder's run.json says of its run.
struct RunSummary {
  std::string run, status, case_hash;
  std::string inputs;  ///< as in the file: paths and hashes of the files that the case names
  std::string steps;
  std::string started, exit_reason;
  std::string first_step, last_step;  ///< the latter empty where none is said
  std::string last_checkpoint;        ///< empty where there has been none
  std::string wall_time, exit_code;
  std::vector<std::string> events;

  /// Whether the run has written a checkpoint, wherever that may be now.
  bool had_checkpoint() const;
  /// Its events up to a step. What was said at an end is of no step, and is said again at the next.
  std::vector<std::string> events_until(std::int64_t step) const;
};

/// That of `directory`; nothing where there is no run.json. Throws InputError when that is none of vug's.
std::optional<RunSummary> read_run_summary(const std::string& directory);

/// What it was made of: enough to make it again.
struct RunOrigin {
  std::string version, commit, compiler, backend, device;
  std::string case_path, case_text;
  std::vector<std::string> overrides;
  std::vector<InputFile> inputs;  ///< paths as seen from where the run was called
};

/// That of the run in `directory`, which has a run.json (read_run_summary). Throws FileError.
RunOrigin read_run_origin(const std::string& directory);

}  // namespace vug
