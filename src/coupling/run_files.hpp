#pragma once
// The files that a run writes during its steps: snapshots and rows of the history.
#include "coupling/simulation.hpp"
#include "io/history_writer.hpp"
#include "io/snapshot_writer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vug {

/// Values at the nodes of the case's probes, named for history.csv.
class Probes {
 public:
  Probes(const Scene& scene, const FieldList& fields) : scene_(scene), fields_(fields) {}
  /// Called by all ranks; the first one gets the values.
  void add(std::vector<HistoryValue>& row) const;

 private:
  const Scene& scene_;
  const FieldList& fields_;
};

/// The names of the columns of the history. Throws InputError where two would be the same: the reader of the case
/// cannot exclude this, because names of columns begin with names from the case. Called by all ranks.
std::vector<std::string> history_columns(const Scene& scene, const Simulation& simulation);

/// The open files of a run. Only the first rank has them; the others take part in reading the fields.
class RunFiles {
 public:
  /// `columns` are those of history_columns. With `resume_step`, continues the files of the run from that step.
  RunFiles(const Scene& scene, const Simulation& simulation, const std::string& directory,
           const std::vector<std::string>& columns, std::optional<std::int64_t> resume_step);

  /// Number of rows in the history; 0 on other ranks than the first.
  std::int64_t rows() const { return history_ ? history_->rows() : 0; }

  void write_snapshot();

  /// Writes and returns a row of the history.
  std::vector<HistoryValue> write_row();
  /// Syncs the rows to the disk.
  void sync_rows() {
    if (history_) history_->sync();
  }
  /// Damaged snapshots of the continued run, one line each.
  std::vector<std::string> passed_over() const {
    return snapshots_ ? snapshots_->passed_over() : std::vector<std::string>{};
  }

 private:
  const Scene& scene_;
  const Simulation& simulation_;
  const std::vector<std::string> columns_;
  FieldList fields_;
  Probes probes_;
  std::optional<SnapshotWriter> snapshots_;
  std::optional<HistoryWriter> history_;
};

}  // namespace vug
