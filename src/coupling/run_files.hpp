#pragma once
// What a run writes as it goes: snapshots and rows of the history.
#include "coupling/simulation.hpp"
#include "io/history_writer.hpp"
#include "io/snapshot_writer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vug {

/// Node values at the probes of the case, named for history.csv.
class Probes {
 public:
  Probes(const Scene& scene, const FieldList& fields) : scene_(scene), fields_(fields) {}
  /// Called by all ranks, of which the first gets the values.
  void add(std::vector<HistoryValue>& row) const;

 private:
  const Scene& scene_;
  const FieldList& fields_;
};

/// Names in a case begin names of columns, in ways that no reader foresees. Throws InputError where two columns of the
/// history would have one name. Called by all ranks.
void require_distinct_columns(const Scene& scene, const Simulation& simulation);

/// The open files of a run: the first rank has them, the others take part in what is read for them.
class RunFiles {
 public:
  /// With `resume_step` the files of the run are continued from there.
  RunFiles(const Scene& scene, const Simulation& simulation, const std::string& directory,
           std::optional<std::int64_t> resume_step);

  /// Rows that the history has; 0 where it is another rank's.
  std::int64_t rows() const { return history_ ? history_->rows() : 0; }

  void write_snapshot();

  /// Writes and returns a row of the history.
  std::vector<HistoryValue> write_row();
  /// Brings the rows to the disk.
  void sync_rows() {
    if (history_) history_->sync();
  }
  /// What could not be continued, a line each.
  std::vector<std::string> passed_over() const {
    return snapshots_ ? snapshots_->passed_over() : std::vector<std::string>{};
  }

 private:
  std::vector<HistoryValue> row() const;

  const Scene& scene_;
  const Simulation& simulation_;
  FieldList fields_;
  Probes probes_;
  std::optional<SnapshotWriter> snapshots_;
  std::optional<HistoryWriter> history_;
};

}  // namespace vug
