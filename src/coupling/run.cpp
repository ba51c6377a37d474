#include "coupling/run.hpp"

#include "coupling/simulation.hpp"
#include "io/history_writer.hpp"
#include "io/progress.hpp"
#include "io/run_record.hpp"
#include "io/snapshot_writer.hpp"
#include "kernels/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#ifndef VUG_COMMIT
#define VUG_COMMIT "unknown"
#endif

namespace vug {

std::int64_t last_step(const Scene& scene) {
  if (scene.time.steps) return *scene.time.steps;
  return static_cast<std::int64_t>(std::ceil(*scene.time.end / scene.lattice.time_step - 1e-6));
}

BuildInfo build_info() {
  BuildInfo info;
  info.version = VUG_VERSION;
  info.commit = VUG_COMMIT;
  info.compiler = VUG_COMPILER;
  info.backend = Exec::name();
  info.threads = Exec().concurrency();
  info.device = runs_on_host ? fmt::format("host, {} threads", info.threads) : std::string(Exec::name()) + " device";
  return info;
}

namespace {

/// Lattice steps between two outputs.
std::int64_t output_interval(const Scene& scene, std::int64_t last) {
  if (scene.output.interval_steps) return *scene.output.interval_steps;
  if (scene.output.interval)
    return std::max<std::int64_t>(1, std::llround(*scene.output.interval / scene.lattice.time_step));
  return std::max<std::int64_t>(1, last);
}

std::optional<RockShape> rock_shape(const Parts& parts) {
  if (!parts.mechanics) return std::nullopt;
  RockShape shape{parts.rock->assembly, {}};
  const Bonds& bonds = parts.mechanics->bonds();
  const auto pair = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, bonds.pair);
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, bonds.vertex);
  for (int b = 0; b < bonds.count; ++b)
    shape.bonds.push_back({{pair(b, 0), pair(b, 1)}, {vertex(b, 0), vertex(b, 1)}});
  return shape;
}

/// Node values at the probes of the case, named for history.csv.
class Probes {
 public:
  Probes(const Scene& scene, const FieldList& fields) : scene_(scene), fields_(fields) {}
  void add(std::vector<HistoryValue>& row) const {
    if (scene_.output.probes.empty()) return;
    const int nx = scene_.lattice.nx, ny = scene_.lattice.ny;
    for (const Field& field : fields_.lattice) {
      std::vector<double> values(static_cast<std::size_t>(nx) * ny * field.components);
      field.read(values);
      for (const Probe& probe : scene_.output.probes) {
        const int x = std::clamp(static_cast<int>(probe.at[0] / scene_.lattice.spacing), 0, nx - 1);
        const int y = std::clamp(static_cast<int>(probe.at[1] / scene_.lattice.spacing), 0, ny - 1);
        for (int c = 0; c < field.components; ++c) {
          const std::string axis = field.components == 1 ? "" : c == 0 ? "_x" : "_y";
          row.push_back({probe.name + "_" + field.name + axis + "_" + field.unit,
                         values[(static_cast<std::size_t>(y) * nx + x) * field.components + c]});
        }
      }
    }
  }

 private:
  const Scene& scene_;
  const FieldList& fields_;
};

/// The open files of a run.
class RunFiles {
 public:
  RunFiles(const Scene& scene, const Simulation& simulation, const std::string& directory)
      : simulation_(simulation),
        fields_(simulation.fields()),
        probes_(scene, fields_),
        snapshots_(directory, simulation.parts().geometry.lattice, scene.lattice.spacing, fields_,
                   {scene.output.fields, scene.output.compress, false, std::nullopt}, rock_shape(simulation.parts())),
        history_(directory + "/history.csv", names(row())) {}

  void write() {
    snapshots_.write(simulation_.clock().time(), simulation_.clock().step);
    std::vector<double> values;
    for (const HistoryValue& value : row()) values.push_back(value.value);
    history_.write(values);
  }

 private:
  std::vector<HistoryValue> row() const {
    std::vector<HistoryValue> values = simulation_.history();
    probes_.add(values);
    return values;
  }
  static std::vector<std::string> names(const std::vector<HistoryValue>& row) {
    std::vector<std::string> names;
    for (const HistoryValue& value : row) names.push_back(value.name);
    return names;
  }

  const Simulation& simulation_;
  FieldList fields_;
  Probes probes_;
  SnapshotWriter snapshots_;
  HistoryWriter history_;
};

RunRecord first_record(const Scene& scene) {
  const BuildInfo build = build_info();
  RunRecord record;
  record.case_path = scene.path;
  record.case_text = scene.source_text;
  record.overrides = scene.overrides;
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

void make_directory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw FileError(fmt::format("{}: cannot make the run directory: {}", directory, error.message()));
}

}  // namespace

RunEnd run_case(const Scene& scene, const RunOptions& options) {
  const std::string directory = options.directory.empty()
                                    ? "runs/" + std::filesystem::path(scene.path).stem().string()
                                    : options.directory;
  const std::int64_t last = std::min(options.steps.value_or(last_step(scene)), last_step(scene));
  const std::int64_t every = output_interval(scene, last);
  Simulation simulation(scene);
  make_directory(directory);
  RunRecord record = first_record(scene);
  write_run_record(directory, record);

  std::ostream silent(nullptr);
  Progress progress(options.progress ? *options.progress : silent, options.terminal && options.progress != nullptr,
                    {0, last, scene.lattice.time_step, simulation.updates_per_step()});
  for (const std::string& warning : scene.warnings) progress.note("warning: " + warning);
  for (const Limit& limit : simulation.limits())
    if (!limit.inside())
      progress.note(fmt::format("warning: {}: {} = {:.5g} is outside its safe range; {}", limit.module, limit.name,
                                limit.value, limit.advice));

  const auto finish = [&](const std::string& status, const std::string& reason, int code) {
    record.status = status;
    record.exit_reason = reason;
    record.exit_code = code;
    record.ended = utc_now();
    record.steps = simulation.clock().step;
    record.simulated_time = simulation.clock().time();
    record.wall_time = progress.wall_time();
    record.mlups = progress.mlups();
    write_run_record(directory, record);
  };

  try {
    RunFiles files(scene, simulation, directory);
    simulation.begin();
    files.write();
    bool stopped = false;
    while (simulation.clock().step < last && !stopped) {
      simulation.step();
      const std::int64_t step = simulation.clock().step;
      const bool output = step % every == 0 || step == last;
      stopped = options.interrupted && *options.interrupted;
      if (output || step % scene.accuracy.guard_interval == 0) simulation.guard();
      if (output || stopped) files.write();
      progress.update(step, simulation.updates_per_step());
    }
    progress.finish(stopped ? "interrupted" : "done");
    finish(stopped ? "interrupted" : "done", stopped ? "interrupted by a signal" : "reached the last step", stopped ? 130 : 0);
    return stopped ? RunEnd::interrupted : RunEnd::done;
  } catch (const StabilityError& error) {
    finish("diverged", error.what(), 3);
    throw;
  } catch (const FileError& error) {
    try {
      finish("failed", error.what(), 4);
    } catch (const FileError&) {
      // the disk that refused the results refuses the record as well; the first error is the one to report
    }
    throw;
  }
}

}  // namespace vug
