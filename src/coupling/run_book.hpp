#pragma once
// The record and the checkpoints of a run in its folder, and the checkpoint from which it continues.
#include "coupling/recorded_run.hpp"
#include "coupling/run.hpp"
#include "coupling/simulation.hpp"
#include "io/checkpoint.hpp"
#include "io/progress.hpp"

#include <cstdint>
#include <exception>
#include <optional>
#include <string>

namespace vug {

/// The folder, the record and the checkpoints of one run. The first of its ranks writes them; the others have a copy of
/// the record. A folder belongs to a run from open() on; before, nothing in it is changed.
class RunBook {
 public:
  /// Throws InputError where the folder contains a run that this one may neither continue nor replace, or one of
  /// another case that this run should continue.
  RunBook(const Scene& scene, const RunOptions& options);

  const std::string& path() const { return recorded_.path(); }
  RunRecord& record() { return recorded_.record(); }
  /// Why the folder could not be locked; otherwise empty.
  std::string warning() const { return recorded_.warning(); }

  /// The newest checkpoint of the run in the folder, the same on all ranks; nothing where there is none.
  std::optional<Checkpoint> latest_checkpoint() const;
  /// Makes this run a continuation of the one that wrote the checkpoint, with its events and wall time until then.
  /// Where another build of vug has written it, returns a line that says so and keeps this as an event; otherwise
  /// returns an empty line.
  std::string go_on_from(const Checkpoint& checkpoint);
  /// The end that the run had when it was last written, where the case gives it a later one.
  const std::optional<TimeSection>& former_end() const { return former_end_; }
  /// The last step that the run in the folder was given, the same on all ranks; 0 where it is not known, or where the
  /// case has another end now.
  std::int64_t former_last_step() const;
  /// Number of rows in the history at the newest checkpoint.
  std::int64_t rows() const { return rows_; }
  /// Makes this run a new one. Throws InputError where this would destroy a run that could be continued.
  void begin_anew();

  /// Takes the folder, removes what is not continued and writes the record, with the last step of the run where it is
  /// known.
  void open(std::optional<std::int64_t> last_step);
  /// Throws FileError where the folder no longer belongs to this run: another one may have started in it.
  void require_ours() const { recorded_.require_ours(); }
  /// Writes the record, then a checkpoint with the state of all ranks and the number of rows in the history.
  void save(Simulation& simulation, std::int64_t rows, const Progress& progress);
  /// Writes the last record of a run that has reached its end. Throws FileError.
  void close_done(const Clock& clock, const Progress& progress);
  /// Writes the last record of a run that `error` has ended. Throws nothing where the record cannot be written.
  void close_failed(const Clock& clock, const Progress& progress, const std::exception& error);

  /// A text that says where the newest checkpoint is.
  std::string last_good() const;

 private:
  std::string checkpoints() const { return path() + "/checkpoint"; }
  CheckpointOwner owner(const Scene& scene);
  StateList own_state();
  void note(const Clock& clock, const Progress& progress);

  const RunOptions& options_;
  RecordedRun recorded_;
  std::optional<TimeSection> former_end_;
  CheckpointOwner owner_;
  std::int64_t rows_ = 0;
};

}  // namespace vug
