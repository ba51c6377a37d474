#pragma once
// The folder of a run or a laboratory test, and its record there (run.json) from the start to the end.
#include "io/run_folder.hpp"
#include "io/run_record.hpp"
#include "io/scene.hpp"

#include <exception>
#include <memory>
#include <optional>
#include <string>

namespace vug {

/// `wanted`, or runs/<name of the case file> where it is empty.
std::string run_directory(const Scene& scene, const std::string& wanted);

/// The folder and the record of a run. A folder belongs to the run from begin() on; before, nothing in it is changed.
class RecordedRun {
 public:
  /// Reads the files that the scene names. A process that does not `write` has the record only. Throws InputError where
  /// the folder contains a run that `use` must not replace; `offer` then says what can be done (RunFolder). Throws
  /// FileError.
  RecordedRun(const Scene& scene, const std::string& directory, RunFolder::Use use, const std::string& offer,
              bool writes = true);

  const std::string& path() const { return path_; }
  RunRecord& record() { return record_; }
  const RunRecord& record() const { return record_; }
  /// Null for a process that does not write.
  const RunFolder* folder() const { return folder_ ? &*folder_ : nullptr; }
  /// Why the folder could not be locked; otherwise empty.
  std::string warning() const { return folder_ ? folder_->warning() : ""; }

  /// Takes the folder and writes the record; with `clear`, removes what an earlier run has left there first. The wall
  /// time from here on is added to that in the record. Throws InputError and FileError.
  void begin(bool clear = false);
  /// Throws FileError where the folder no longer belongs to this run: another one may have started in it.
  void require_ours() const;
  /// Writes the record with the wall time until now. Throws FileError.
  void write();
  /// Writes the last record of a run that has reached its end. Throws FileError.
  void close_done(const std::string& reason);
  /// Writes the last record of a run that `error` has ended, also when memory was insufficient or the disk is full.
  /// Throws nothing where the record cannot be written, because `error` is the one to report.
  void close_failed(const std::exception& error);

 private:
  std::string path_;
  std::optional<RunFolder> folder_;  ///< only of a process that writes
  RunRecord record_;
  double earlier_time_ = 0;                                              ///< s, of earlier parts of the run
  double start_ = 0;                                                     ///< s, of steady_seconds()
  std::unique_ptr<char[]> reserve_ = std::make_unique<char[]>(1 << 20);  ///< freed to record a lack of memory
};

}  // namespace vug
