#include "coupling/run.hpp"

#include "coupling/events.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/limit_text.hpp"
#include "coupling/rock_fields.hpp"
#include "coupling/run_directory.hpp"
#include "coupling/schedule.hpp"
#include "coupling/simulation.hpp"
#include "io/checkpoint.hpp"
#include "io/history_writer.hpp"
#include "io/progress.hpp"
#include "io/require_fields.hpp"
#include "io/run_folder.hpp"
#include "io/run_record.hpp"
#include "io/snapshot_writer.hpp"
#include "kernels/base/require.hpp"
#include "kernels/host/interruption.hpp"
#include "ranks/traffic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <numeric>

namespace vug {

std::int64_t last_step(const Scene& scene) {
  if (scene.time.steps) return *scene.time.steps;
  return static_cast<std::int64_t>(std::ceil(*scene.time.end / scene.lattice.time_step - 1e-6));
}

namespace {

std::int64_t steps_in(double seconds, const Scene& scene) {
  return std::max<std::int64_t>(1, std::llround(seconds / scene.lattice.time_step));
}

/// Of what comes every so many steps or, in a time that is not that of the steps, every so many seconds.
Schedule schedule(const Scene& scene, std::int64_t steps, std::optional<double> seconds) {
  return {steps, scene.accuracy.dissolution_tolerance > 0 ? seconds.value_or(0) : 0};
}

/// Lattice steps between two outputs.
std::int64_t output_interval(const Scene& scene) {
  if (scene.output.interval_steps) return *scene.output.interval_steps;
  if (scene.output.interval) return steps_in(*scene.output.interval, scene);
  return std::max<std::int64_t>(1, last_step(scene));
}

/// Lattice steps between two rows of the history: by default about 400 in all, where they cost nothing that counts.
std::int64_t history_interval(const Scene& scene) {
  constexpr std::int64_t rows = 400, fewest_steps = 100;
  if (scene.output.history_interval) return steps_in(*scene.output.history_interval, scene);
  return std::max(fewest_steps, last_step(scene) / rows);
}

/// Rows of the history up to a step, that of the start among them.
std::int64_t rows_until(const Scene& scene, std::int64_t step) {
  const std::int64_t output = output_interval(scene), history = history_interval(scene);
  const std::int64_t both = output / std::gcd(output, history) <= step / history ? std::lcm(output, history) : step + 1;
  return 1 + step / output + step / history - step / both;
}

/// Lattice steps between two checkpoints.
std::int64_t checkpoint_interval(const Scene& scene) {
  return scene.output.checkpoint_interval ? steps_in(*scene.output.checkpoint_interval, scene) : output_interval(scene);
}

Schedule output_schedule(const Scene& scene) {
  std::optional<double> seconds = scene.output.interval;
  if (!seconds && !scene.output.interval_steps) seconds = scene.time.end;
  return schedule(scene, output_interval(scene), seconds);
}
Schedule row_schedule(const Scene& scene) {
  constexpr double rows = 400;
  std::optional<double> seconds = scene.output.history_interval;
  if (!seconds && scene.time.end) seconds = *scene.time.end / rows;
  return schedule(scene, history_interval(scene), seconds);
}
Schedule checkpoint_schedule(const Scene& scene) {
  if (!scene.output.checkpoint_interval) return output_schedule(scene);
  return schedule(scene, checkpoint_interval(scene), scene.output.checkpoint_interval);
}

RunFolder::Use use_of(const RunOptions& options) {
  if (options.resume) return RunFolder::Use::resume;
  return options.overwrite ? RunFolder::Use::overwrite : RunFolder::Use::fresh;
}

/// Says which of the files that a case names are not those of the run that `held` describes.
std::string what_has_changed(const RunRecord& record, const RunSummary& held) {
  for (const InputFile& input : record.inputs)
    if (held.inputs.find(input.hash) == std::string::npos) return input.path + " has changed since";
  return "the text of the case or a --set differs";
}

std::optional<RockShape> rock_shape(const Parts& parts) {
  if (!parts.mechanics) return std::nullopt;
  return shape_of_rock(parts.rock->assembly, parts.mechanics->bonds());
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
  /// With `resume_step` the files of the run are continued from there.
  RunFiles(const Scene& scene, const Simulation& simulation, const std::string& directory,
           std::optional<std::int64_t> resume_step)
      : simulation_(simulation),
        fields_(simulation.fields()),
        probes_(scene, fields_),
        snapshots_(directory, simulation.parts().geometry.lattice, scene.lattice.spacing, fields_,
                   {scene.output.fields, scene.output.compress, false, resume_step}, rock_shape(simulation.parts())),
        history_(directory + "/history.csv", names(row()),
                 resume_step ? std::optional(simulation.clock().time()) : std::nullopt) {}

  /// Rows of the history that is continued.
  std::int64_t rows_kept() const { return history_.kept(); }

  void write_snapshot() { snapshots_.write(simulation_.clock().time(), simulation_.clock().step); }

  /// Writes and returns a row of the history.
  std::vector<HistoryValue> write_row() {
    const std::vector<HistoryValue> written = row();
    std::vector<double> values;
    for (const HistoryValue& value : written) values.push_back(value.value);
    history_.write(values);
    return written;
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

/// One run from its first step to its last.
class Run {
 public:
  Run(const Scene& scene, const RunOptions& options)
      : scene_(scene),
        options_(options),
        ranks_(options.ranks),
        path_(run_directory(scene, options.directory)),
        folder_(folder()),
        record_(first_record(scene)),
        owner_(owner()),
        last_(std::min(options.steps.value_or(last_step(scene)), last_step(scene))),
        simulation_(scene, options.ranks) {
    require_fields(simulation_.fields(), scene.output.fields);
  }

  void operator()() {
    resume();
    const StopsInOrder in_order;  // from here on there is something to bring to an end
    if (folder_) {
      folder_->take();
      if (options_.resume && !resumed_at_) folder_->clear();
      if (!simulation_.parts().ageing) record_.last_step = last_;  // else nobody knows how many there will be
      write_run_record(path_, record_);
    }
    std::ostream silent(nullptr);
    Progress progress(options_.progress ? *options_.progress : silent, options_.terminal && options_.progress,
                      {simulation_.clock().step, last_, scene_.lattice.time_step, simulation_.updates_per_step()});
    try {
      warn(progress);
      advance(progress);
      progress.finish("done");
      finish(progress, "done", "reached the last step", 0);
    } catch (const Interrupted& stop) {
      progress.finish("interrupted");
      const std::string reason = fmt::format("{}; {}", stop.what(), last_good());
      finish(progress, "interrupted", reason, 130);
      throw Interrupted(reason);
    } catch (const StabilityError& error) {
      const std::string reason = fmt::format("{}; {}", error.what(), last_good());
      finish(progress, "diverged", reason, 3);
      throw StabilityError(reason);
    } catch (const FileError& error) {
      fail(progress, error.what(), 4);
      throw;
    } catch (const std::exception& error) {  // memory that did not suffice after all
      fail(progress, error.what(), 5);
      throw;
    }
  }

 private:
  /// That of the rank that writes.
  std::optional<RunFolder> folder() const {
    if (!ranks_.first()) return std::nullopt;
    return std::optional<RunFolder>(std::in_place, path_, use_of(options_),
                                    "--resume continues it, --overwrite replaces it, -o DIR leaves it alone");
  }

  /// This run, or that which it continues: of the same case, or nothing is touched.
  CheckpointOwner owner() {
    const std::string hash = case_hash(record_.case_text, record_.overrides, record_.inputs);
    if (!options_.resume) return {hash, record_.run};
    if (!folder_) return {hash, ""};
    const std::optional<RunSummary>& held = folder_->held();
    if (!held) return {hash, ""};
    if (held->case_hash != hash)
      throw InputError(fmt::format("{}: holds a run of another case, which this one cannot continue: {}", path_,
                                   what_has_changed(record_, *held)));
    record_.run = held->run;
    return {hash, held->run};
  }

  void resume() {
    if (!options_.resume) return;
    const std::optional<Checkpoint> checkpoint = latest_checkpoint();
    if (!checkpoint) {
      notes_.push_back(
          fmt::format("note: {} has no checkpoint to continue from: the run begins at its first step", path_));
      owner_.run = record_.run;
      return;
    }
    for (const std::string& refused : checkpoint->refused()) notes_.push_back("warning: passed over: " + refused);
    simulation_.restore([&](StateList& state) { checkpoint->load(state); });
    if (simulation_.clock().step != checkpoint->step())
      throw FileError(checkpoint->path() + ": the checkpoint is of another step than it says");
    owner_.run = record_.run = checkpoint->run();
    resumed_at_ = last_checkpoint_ = record_.first_step = checkpoint->step();
  }

  /// Every rank takes part in the sums of a row.
  std::vector<HistoryValue> write_row(std::optional<RunFiles>& files) const {
    return files ? files->write_row() : simulation_.history();
  }

  /// The first rank finds it, all read it.
  std::optional<Checkpoint> latest_checkpoint() const {
    std::optional<Checkpoint> found;
    if (ranks_.first()) found = Checkpoint::latest(checkpoints(), owner_);
    const std::string path = ranks_.told(found ? found->path() : "");
    if (!ranks_.first() && !path.empty()) found = Checkpoint::open(path, owner_);
    return found;
  }

  /// On any of the ranks.
  bool someone_is_to_stop() const {
    const Phase phase(ranks_, "agreement");
    return ranks_.most(stop_requested() ? 1 : 0) > 0;
  }

  /// How the ranks share the lattice.
  std::string shares() const {
    const Partition& rows = simulation_.parts().geometry.split.rows();
    std::string text = fmt::format("ranks: {}, rows of the lattice from", ranks_.size());
    for (int r = 0; r < ranks_.size(); ++r) text += fmt::format(" {}", rows.first(r));
    return text + fmt::format(", the largest share of the work {:.3f} of the mean", rows.imbalance());
  }

  void warn(Progress& progress) const {
    if (folder_ && !folder_->warning().empty()) progress.note("warning: " + folder_->warning());
    if (!ranks_.alone()) progress.note(shares());
    for (const std::string& note : notes_) progress.note(note);
    for (const std::string& warning : scene_.warnings) progress.note("warning: " + warning);
    const Parts& parts = simulation_.parts();
    for (const std::string& warning : find_flow_paths(scene_, parts.geometry, parts.units).warnings)
      progress.note("warning: " + warning);
    for (const Limit& limit : simulation_.limits())
      if (!limit.inside()) progress.note("warning: " + warning_of(limit));
  }

  /// Steps until the end. Throws Interrupted, with the state in a checkpoint where there is one.
  void advance(Progress& progress) {
    std::optional<RunFiles> files;
    if (ranks_.first())
      files.emplace(scene_, simulation_, path_, resumed_at_);
    else
      simulation_.history();  // for the names of its columns
    if (files && resumed_at_ && !simulation_.parts().ageing)
      if (const std::int64_t due = rows_until(scene_, *resumed_at_); files->rows_kept() < due)
        progress.note(fmt::format("warning: {}/history.csv has lost rows: {} of {} up to step {} are left", path_,
                                  files->rows_kept(), due, *resumed_at_));
    if (!resumed_at_) {
      simulation_.begin();
      if (files) files->write_snapshot();
      write_row(files);
    }
    Events events(simulation_);
    const auto tell = [&](const std::vector<std::string>& news) {
      for (const std::string& line : news) progress.note(line);
      record_.events.insert(record_.events.end(), news.begin(), news.end());
    };
    const Schedule output = output_schedule(scene_), history = row_schedule(scene_);
    const Schedule checkpoint = checkpoint_schedule(scene_);
    while (!ended()) {
      const Clock before = simulation_.clock();
      simulation_.step();
      const Clock& clock = simulation_.clock();
      const std::int64_t step = clock.step;
      const bool stop = someone_is_to_stop();
      const bool write_now = output.due(before, clock) || ended();
      const bool row = write_now || history.due(before, clock);
      const bool save = stop || checkpoint.due(before, clock) || ended();
      if (row || save || step % scene_.accuracy.guard_interval == 0) {
        simulation_.guard();
        tell(events.look(simulation_));
      }
      if (write_now || save) simulation_.gather();
      if (files && write_now) files->write_snapshot();
      if (row) tell(events.look_at_row(simulation_, write_row(files)));
      if (save) {
        if (files) write_checkpoint(checkpoints(), simulation_.state(), step, simulation_.clock().time(), owner_);
        last_checkpoint_ = step;
        const Phase phase(ranks_, "files");
        ranks_.most(0);  // nobody ends while it is written
      }
      progress.update(step, simulation_.updates_per_step(), clock.ahead);
      if (stop && !ended()) throw Interrupted(stop_reason());
    }
    tell(events.sum_up(simulation_));
    if (!ranks_.alone())
      for (const std::string& line : traffic_table(ranks_, simulation_.clock().step - record_.first_step))
        progress.note(line);
  }

  /// Whether the last step is done, or the rock as old as it was to get.
  bool ended() const {
    const Clock& clock = simulation_.clock();
    return clock.step >= last_ || (clock.ahead > 0 && scene_.time.end && clock.time() >= *scene_.time.end);
  }

  std::string checkpoints() const { return path_ + "/checkpoint"; }

  std::string last_good() const {
    if (!last_checkpoint_) return "there is no checkpoint yet";
    return fmt::format("the last good state is the checkpoint of step {} in {}", *last_checkpoint_, checkpoints());
  }

  void fail(const Progress& progress, const std::string& reason, int code) {
    reserve_.reset();
    try {
      finish(progress, "failed", reason, code);
    } catch (const FileError&) {
      // the disk that refused the results refuses the record as well; the first error is the one to report
    }
  }

  void finish(const Progress& progress, const std::string& status, const std::string& reason, int code) {
    if (!folder_) return;
    record_.status = status;
    record_.exit_reason = reason;
    record_.exit_code = code;
    record_.ended = utc_now();
    record_.steps = simulation_.clock().step;
    record_.simulated_time = simulation_.clock().time();
    record_.wall_time = progress.wall_time();
    record_.mlups = progress.mlups();
    write_run_record(path_, record_);
  }

  const Scene& scene_;
  const RunOptions& options_;
  Ranks ranks_;
  std::string path_;
  std::optional<RunFolder> folder_;  ///< of the rank that writes
  RunRecord record_;
  CheckpointOwner owner_;
  std::int64_t last_;
  Simulation simulation_;
  std::vector<std::string> notes_;  ///< of what happened before there was a log
  std::optional<std::int64_t> resumed_at_, last_checkpoint_;
  std::unique_ptr<char[]> reserve_ = std::make_unique<char[]>(1 << 20);  ///< to say so when the memory does not suffice
};

}  // namespace

void run_case(const Scene& scene, const RunOptions& options) {
  Run(scene, options)();
}

}  // namespace vug
