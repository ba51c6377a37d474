#include "coupling/recorded_run.hpp"

#include "base/require.hpp"
#include "coupling/program_info.hpp"
#include "host/this_process.hpp"

namespace vug {

namespace {

/// The record of a run of `scene` that begins now; reads the files that the scene names. Throws FileError.
RunRecord first_record(const Scene& scene) {
  const BuildInfo build = build_info();
  RunRecord record;
  record.case_path = scene.path;
  record.case_text = scene.source_text;
  record.overrides = scene.overrides;
  for (const std::string& path : input_files(scene)) record.inputs.push_back(digest_of_file(path));
  record.run = new_run_name();
  record.version = build.version;
  record.commit = build.commit;
  record.compiler = build.compiler;
  record.backend = build.backend;
  record.device = build.device;
  record.precision = scene.accuracy.precision == Precision::single_precision ? "single" : "double";
  record.threads = build.threads;
  record.started = utc_now();
  return record;
}

}  // namespace

std::string run_directory(const Scene& scene, const std::string& wanted) {
  return wanted.empty() ? results_directory(scene.path) : wanted;
}

RecordedRun::RecordedRun(const Scene& scene, const std::string& directory, RunFolder::Use use, const std::string& offer,
                         bool writes)
    : path_(run_directory(scene, directory)) {
  if (writes) folder_.emplace(path_, use, offer);
  record_ = first_record(scene);
}

void RecordedRun::begin(bool clear) {
  start_ = steady_seconds();
  earlier_time_ = record_.wall_time;
  if (!folder_) return;
  folder_->take();
  if (clear) folder_->clear();
  write_run_record(path_, record_);
}

void RecordedRun::require_ours() const {
  if (folder_ && !folder_->is_ours())
    throw FileError(path_ + ": was removed or replaced while the run wrote there; nothing more is written to it");
}

void RecordedRun::write() {
  record_.wall_time = earlier_time_ + steady_seconds() - start_;
  if (folder_) write_run_record(path_, record_);
}

void RecordedRun::close_done(const std::string& reason) {
  require_ours();
  note_end(record_, "done", reason, done);
  record_.ended = utc_now();
  write();
}

void RecordedRun::close_failed(const std::exception& error) {
  reserve_.reset();
  note_failure(record_, error);
  record_.ended = utc_now();
  try {
    require_ours();
    write();
  } catch (const FileError&) {
    // where results cannot be written, the record cannot either; the first error is the one to report
  }
}

}  // namespace vug
