#pragma once
// run.json: where the results of a run come from.
#include "host/exit_code.hpp"

#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vug {

/// A file that a case names, and a digest of its contents.
struct InputFile {
  std::string path;
  std::uint64_t bytes = 0;
  std::string hash;  ///< 16 hexadecimal digits (FNV-1a)
};

/// Reads the file. Throws InputError when there is none, FileError.
InputFile digest_of_file(const std::string& path);

/// Provenance of a run, written at its start (status "running") and again at its end.
struct RunRecord {
  std::string case_path, case_text;
  std::vector<std::string> overrides;
  std::vector<InputFile> inputs;
  std::string run;  ///< a name that no other run has; a resumed run keeps its name
  std::string version, commit, compiler, backend, device, precision;
  int threads = 1;  ///< of each rank
  int ranks = 1;
  std::string status = "running";  ///< running, done, interrupted, diverged or failed
  std::string exit_reason;         ///< one line; empty while running
  int exit_code = 0;
  std::string started, ended;   ///< UTC, ISO 8601
  std::int64_t first_step = 0;  ///< more than 0 after --resume
  std::int64_t steps = 0;       ///< lattice steps reached
  std::int64_t last_step = 0;   ///< step at which the run is done
  /// Step of the newest checkpoint when this was written; none before the first one.
  std::optional<std::int64_t> last_checkpoint;
  double simulated_time = 0;        ///< s reached
  double wall_time = 0;             ///< s, sum over all parts of a resumed run
  double mlups = 0;                 ///< million lattice-node updates per second, since first_step
  std::vector<std::string> events;  ///< one line each: first failed bond, breakthrough, ...
  /// Results of a laboratory test, names with their units; absent from the file when empty.
  std::vector<std::pair<std::string, double>> results;
};

/// Notes in the record how the run has ended, why and with which exit code.
void note_end(RunRecord& record, const std::string& status, const std::string& reason, ExitCode code);

/// Notes in the record that `error` has ended the run: as interrupted, diverged or failed, why and with which exit code
/// (host/exit_code.hpp).
void note_failure(RunRecord& record, const std::exception& error);

/// Writes `directory`/run.json: the record, the hash of the case and the peak memory of the process so far. The file is
/// replaced atomically. Throws FileError.
void write_run_record(const std::string& directory, const RunRecord& record);

/// Hash of the input of a run: the text of the case, its overrides and the files it names, 16 hexadecimal digits
/// (FNV-1a).
std::string case_hash(const std::string& case_text, const std::vector<std::string>& overrides,
                      const std::vector<InputFile>& inputs = {});

/// A name for a run that begins now, on any machine: 16 hexadecimal digits.
std::string new_run_name();

/// Now, as "2026-01-31T23:59:59Z".
std::string utc_now();

}  // namespace vug
