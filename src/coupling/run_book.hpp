#pragma once
// What a run keeps of itself in its folder: the record and the checkpoints, and which of these it goes on from.
#include "coupling/run.hpp"
#include "coupling/simulation.hpp"
#include "host/exit_code.hpp"
#include "io/checkpoint.hpp"
#include "io/progress.hpp"
#include "io/run_folder.hpp"
#include "io/run_record.hpp"

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>

namespace vug {

/// The folder, the record and the checkpoints of one run. The first of its ranks writes them; the others know the
/// record. A folder belongs to a run once that has taken it: until then nothing there is touched.
class RunBook {
 public:
  /// Throws InputError where the folder holds a run that this one may neither continue nor replace, or one of another
  /// case.
  RunBook(const Scene& scene, const RunOptions& options);

  const std::string& path() const { return path_; }
  RunRecord& record() { return record_; }
  /// Why the folder is not locked, where it could not be; else empty.
  std::string warning() const;

  /// The newest checkpoint of the run that is there, the same for all ranks; none where there is none.
  std::optional<Checkpoint> latest_checkpoint() const;
  /// Makes this run the one that the checkpoint is of: what happened until then belongs to it, and the time it took.
  /// Returns, and keeps as an event, that another program has computed it, where one has; else an empty line.
  std::string go_on_from(const Checkpoint& checkpoint);
  /// Rows that the history had at the newest checkpoint.
  std::int64_t rows() const { return rows_; }
  /// Makes this run a new one. Throws InputError where one would be lost that could be continued.
  void begin_anew();

  /// Takes the folder, clears it of what is not continued and writes the record, with the step at which the run will
  /// be done where that is known.
  void open(std::optional<std::int64_t> last_step);
  /// Throws FileError where the folder is no longer this run's: another one may have begun in it.
  void require_ours() const;
  /// Writes a checkpoint of what the ranks have computed and of how many rows the history has; before it, the record.
  void save(Simulation& simulation, std::int64_t rows, const Progress& progress);
  /// The last record of a run that has reached its end. Throws FileError.
  void close_done(const Clock& clock, const Progress& progress);
  /// The last record of one that has ended before: how, why, and with which exit code. Why it ended is what is to be
  /// reported: where the record cannot be written, nothing is thrown.
  void close_early(const Clock& clock, const Progress& progress, const std::string& status, const std::string& reason,
                   ExitCode code);
  /// The same of a run that failed, also where memory did not suffice or the disk is full.
  void close_failed(const Clock& clock, const Progress& progress, const std::exception& error);

  /// Says where the newest checkpoint is.
  std::string last_good() const;

 private:
  std::string checkpoints() const { return path_ + "/checkpoint"; }
  CheckpointOwner owner();
  StateList own_state();
  void write(const Clock& clock, const Progress& progress);
  void write_end(const Clock& clock, const Progress& progress);
  void try_to_write_end(const Clock& clock, const Progress& progress);

  const RunOptions& options_;
  std::string path_;
  std::optional<RunFolder> folder_;  ///< of the rank that writes
  RunRecord record_;
  CheckpointOwner owner_;
  std::int64_t rows_ = 0;
  double earlier_time_ = 0;                                              ///< s that earlier parts of the run have taken
  std::unique_ptr<char[]> reserve_ = std::make_unique<char[]>(1 << 20);  ///< to say so when the memory does not suffice
};

}  // namespace vug
