#include "coupling/run_directory.hpp"

#include "io/run_folder.hpp"
#include "kernels/launch/launch.hpp"

#include <fmt/format.h>

#ifndef VUG_COMMIT
#define VUG_COMMIT "unknown"
#endif

namespace vug {

BuildInfo build_info() {
  BuildInfo info;
  info.version = VUG_VERSION;
  info.commit = VUG_COMMIT;
  info.compiler = VUG_COMPILER;
  info.backend = Exec::name();
  info.threads = Exec().concurrency();
  info.device =
      shares_host_memory ? fmt::format("host, {} threads", info.threads) : std::string(Exec::name()) + " device";
  return info;
}

std::string version_line() {
  return fmt::format("vug {} (commit {}, {})", VUG_VERSION, VUG_COMMIT, Exec::name());
}

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

std::string run_directory(const Scene& scene, const std::string& wanted) {
  return wanted.empty() ? results_directory(scene.path) : wanted;
}

}  // namespace vug
