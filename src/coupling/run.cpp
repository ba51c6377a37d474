#include "coupling/run.hpp"

#include "coupling/events.hpp"
#include "coupling/flow_paths.hpp"
#include "coupling/limit_text.hpp"
#include "coupling/rock_limits.hpp"
#include "coupling/run_directory.hpp"
#include "coupling/run_files.hpp"
#include "coupling/schedule.hpp"
#include "coupling/simulation.hpp"
#include "host/interruption.hpp"
#include "io/checkpoint.hpp"
#include "io/progress.hpp"
#include "io/require_fields.hpp"
#include "io/rock_inertia.hpp"
#include "io/run_folder.hpp"
#include "io/run_record.hpp"
#include "kernels/base/require.hpp"
#include "ranks/mpi.hpp"
#include "ranks/traffic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <memory>
#include <span>

namespace vug {

namespace {

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
    if (!resumed_at_) require_distinct_columns(scene_, simulation_);
    const StopsInOrder in_order;  // from here on there is something to bring to an end
    if (folder_) {
      folder_->take();
      if (options_.resume && !resumed_at_) folder_->clear();
      if (!simulation_.parts().ageing) record_.last_step = last_;  // else nobody knows how many there will be
      write_run_record(path_, record_);
    }
    std::ostream silent(nullptr);
    std::ostream* const log = options_.progress ? options_.progress : options_.warnings;
    Progress progress(log ? *log : silent, options_.terminal && options_.progress,
                      {simulation_.clock().step, last_, scene_.lattice.time_step, simulation_.updates_per_step(),
                       options_.progress == nullptr});
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
    } catch (const std::exception& error) {
      fail(progress, error);
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
      if (folder_) folder_->require_dispensable();
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
    continue_record(checkpoint->step());
    if (last_ < checkpoint->step())
      notes_.push_back(fmt::format("note: --steps {}: the run is at step {} already", last_, checkpoint->step()));
    last_ = std::max(last_, checkpoint->step());
    resumed_at_ = record_.last_checkpoint = record_.first_step = record_.steps = checkpoint->step();
  }

  /// What happened until the checkpoint belongs to the run, and the time that its earlier parts have taken.
  void continue_record(std::int64_t step) {
    if (!folder_ || !folder_->held() || folder_->held()->run != record_.run) return;
    record_.events = folder_->held()->events_until(step);
    earlier_time_ = record_.wall_time = std::strtod(folder_->held()->wall_time.c_str(), nullptr);
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
    text += fmt::format(", the largest share of the work {:.3f} of the mean", rows.imbalance());
    return takes_device_memory() ? text : text + "; messages go by way of the host";
  }

  void warn(Progress& progress) const {
    if (folder_ && !folder_->warning().empty()) progress.note("warning: " + folder_->warning());
    if (!ranks_.alone()) progress.note(shares());
    for (const std::string& note : notes_) progress.note(note);
    if (scene_.mechanics && scene_.mechanics->scaling_chosen) progress.note("note: " + mass_scaling_note(scene_));
    for (const std::string& warning : scene_.warnings) progress.note("warning: " + warning);
    const Parts& parts = simulation_.parts();
    if (!parts.warning.empty()) progress.note("warning: " + parts.warning);
    if (parts.rock)
      if (const auto remark = remark_on_triangles(parts.rock->assembly, scene_.lattice.spacing))
        progress.note("warning: " + *remark);
    for (const std::string& warning : find_flow_paths(scene_, parts.geometry, parts.units).warnings)
      progress.note("warning: " + warning);
    for (const Limit& limit : simulation_.limits())
      if (!limit.inside()) progress.note("warning: " + warning_of(limit));
  }

  /// Steps until the end. Throws Interrupted, with the state in a checkpoint where there is one.
  void advance(Progress& progress) {
    RunFiles files(scene_, simulation_, path_, resumed_at_);
    if (ranks_.first() && resumed_at_ && !simulation_.parts().ageing)
      if (const std::int64_t due = rows_until(scene_, *resumed_at_); files.rows_kept() < due)
        progress.note(fmt::format("warning: {}/history.csv has lost rows: {} of {} up to step {} are left", path_,
                                  files.rows_kept(), due, *resumed_at_));
    const auto tell = [&](const std::vector<std::string>& news) {
      for (const std::string& line : news) progress.note(line);
      record_.events.insert(record_.events.end(), news.begin(), news.end());
    };
    if (!resumed_at_) {
      simulation_.begin();
      tell(Events::of_the_start(simulation_));
      files.write_snapshot();
      files.write_row();
    }
    Events events(simulation_, record_.events);
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
      if (write_now) {
        const Phase phase(ranks_, "files");
        files.write_snapshot();
      }
      if (row) tell(events.look_at_row(simulation_, files.write_row()));
      if (save) save_state(progress);
      progress.update(step, simulation_.updates_per_step(), clock.ahead);
      if (stop && !ended()) throw Interrupted(stop_reason());
    }
    tell(events.sum_up(simulation_));
    if (!ranks_.alone())
      for (const std::string& line : traffic_table(ranks_, simulation_.clock().step - record_.first_step))
        progress.note(line);
  }

  /// All ranks hand on what the first one writes into a checkpoint.
  void save_state(const Progress& progress) {
    const Phase phase(ranks_, "files");
    const StateList state = simulation_.state();
    const Clock& clock = simulation_.clock();
    if (folder_) write_record(progress);  // first, that what goes on from the checkpoint finds what happened until then
    if (ranks_.first())
      write_checkpoint(checkpoints(), state, clock.step, clock.time(), owner_);
    else
      for (const StateBlock& block : state.blocks) block.save([](std::span<const std::byte>) {});
    const bool first = !record_.last_checkpoint;
    record_.last_checkpoint = clock.step;
    if (folder_ && first) write_run_record(path_, record_);  // that there has been one, should it get lost
    ranks_.most(0);                                          // nobody ends while it is written
  }

  /// Whether the last step is done, or the rock as old as it was to get.
  bool ended() const {
    const Clock& clock = simulation_.clock();
    return clock.step >= last_ || (clock.ahead > 0 && scene_.time.end && clock.time() >= *scene_.time.end);
  }

  std::string checkpoints() const { return path_ + "/checkpoint"; }

  std::string last_good() const {
    if (!record_.last_checkpoint) return "there is no checkpoint yet";
    return fmt::format("the last good state is the checkpoint of step {} in {}", *record_.last_checkpoint,
                       checkpoints());
  }

  void fail(const Progress& progress, const std::exception& error) {
    reserve_.reset();
    try {
      note_failure(record_, error);
      finish(progress);
    } catch (const FileError&) {
      // the disk that refused the results refuses the record as well; the first error is the one to report
    }
  }

  void finish(const Progress& progress, const std::string& status, const std::string& reason, int code) {
    record_.status = status;
    record_.exit_reason = reason;
    record_.exit_code = code;
    finish(progress);
  }

  void finish(const Progress& progress) {
    if (!folder_) return;
    record_.ended = utc_now();
    write_record(progress);
  }

  /// With how far the run is now.
  void write_record(const Progress& progress) {
    record_.steps = simulation_.clock().step;
    record_.simulated_time = simulation_.clock().time();
    record_.wall_time = earlier_time_ + progress.wall_time();
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
  std::optional<std::int64_t> resumed_at_;
  double earlier_time_ = 0;                                              ///< s that earlier parts of the run have taken
  std::unique_ptr<char[]> reserve_ = std::make_unique<char[]>(1 << 20);  ///< to say so when the memory does not suffice
};

}  // namespace

void run_case(const Scene& scene, const RunOptions& options) {
  Run(scene, options)();
}

}  // namespace vug
