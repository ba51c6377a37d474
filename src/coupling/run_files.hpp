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
  /// Reads each field once.
  void add(std::vector<HistoryValue>& row) const;

 private:
  const Scene& scene_;
  const FieldList& fields_;
};

/// The open files of a run.
class RunFiles {
 public:
  /// With `resume_step` the files of the run are continued from there.
  RunFiles(const Scene& scene, const Simulation& simulation, const std::string& directory,
           std::optional<std::int64_t> resume_step);

  /// Rows of the history that is continued.
  std::int64_t rows_kept() const { return history_.kept(); }

  void write_snapshot() { snapshots_.write(simulation_.clock().time(), simulation_.clock().step); }

  /// Writes and returns a row of the history.
  std::vector<HistoryValue> write_row();

 private:
  std::vector<HistoryValue> row() const;

  const Simulation& simulation_;
  FieldList fields_;
  Probes probes_;
  SnapshotWriter snapshots_;
  HistoryWriter history_;
};

}  // namespace vug
