#pragma once
// Reads run.json: what a run says about itself and its origin.
#include "io/run_record.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// What run.json of a folder says about its run.
struct RunSummary {
  std::string run, status, case_hash;
  std::string inputs;  ///< as in the file: paths and hashes of the files that the case names
  std::string steps;
  std::string started, exit_reason;
  std::string first_step, last_step;  ///< the latter empty where the file does not have it
  std::string last_checkpoint;        ///< empty where there has been none
  std::string wall_time, exit_code;
  std::vector<std::string> events;

  /// Whether the run has ever written a checkpoint, even if that is no longer in the folder.
  bool had_checkpoint() const;
  /// The events up to a step. Those written at the end of a run belong to no step and are left out; the next end
  /// repeats them.
  std::vector<std::string> events_until(std::int64_t step) const;
};

/// Reads run.json of `directory`; returns nothing where there is none. Throws InputError when it is not one of
/// vug's, FileError where the directory may not be looked into.
std::optional<RunSummary> read_run_summary(const std::string& directory);

/// Everything that is needed to repeat a run.
struct RunOrigin {
  std::string version, commit, compiler, backend, device;
  std::string case_path, case_text;
  std::vector<std::string> overrides;
  std::vector<InputFile> inputs;  ///< relative to the folder in which the run was started
};

/// Reads the origin of the run in `directory`, which has a run.json (read_run_summary). Throws FileError.
RunOrigin read_run_origin(const std::string& directory);

}  // namespace vug
