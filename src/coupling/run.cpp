#include "coupling/run.hpp"

#include "base/require.hpp"
#include "coupling/carried_steps.hpp"
#include "coupling/case_warnings.hpp"
#include "coupling/events.hpp"
#include "coupling/limit_text.hpp"
#include "coupling/output_schedule.hpp"
#include "coupling/run_book.hpp"
#include "coupling/run_files.hpp"
#include "coupling/simulation.hpp"
#include "host/interruption.hpp"
#include "io/checkpoint.hpp"
#include "io/progress.hpp"
#include "io/require_fields.hpp"
#include "io/rock_inertia.hpp"
#include "ranks/mpi.hpp"
#include "ranks/stop.hpp"
#include "ranks/traffic.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

namespace vug {

namespace {

/// One run from its first step to its last.
class Run {
 public:
  Run(const Scene& scene, const RunOptions& options)
      : scene_(scene),
        options_(options),
        ranks_(options.ranks),
        book_(scene, options),
        last_(options.steps.value_or(last_step(scene))),
        simulation_(scene, options.ranks) {
    require_fields(simulation_.fields(), scene.output.fields);
    if (!simulation_.parts().ageing || !scene.time.end || last_ <= last_step(scene)) return;
    notes_.push_back(
        fmt::format("note: --steps {}: a run with accuracy.dissolution_tolerance ends at the age of {:g} s "
                    "(time.end) at the latest",
                    last_, *scene.time.end));
    last_ = last_step(scene);
  }

  void operator()() {
    resume();
    columns_ = history_columns(scene_, simulation_);
    const StopsInOrder in_order;  // from here on, a stop has to end the run properly
    // with an ageing factor, the number of steps is not known in advance
    book_.open(simulation_.parts().ageing ? std::nullopt : std::optional(last_));
    std::ostream silent(nullptr);
    std::ostream* const log = options_.progress ? options_.progress : options_.warnings;
    Progress progress(log ? *log : silent, options_.terminal && options_.progress,
                      {simulation_.clock().step, last_, scene_.lattice.time_step, simulation_.updates_per_step(),
                       options_.progress == nullptr, simulation_.clock().ahead});
    try {
      warn(progress);
      advance(progress);
      progress.finish("done");
      book_.close_done(simulation_.clock(), progress);
      say_when_ended(options_.words_when_done);
    } catch (const Interrupted& stop) {
      progress.finish("interrupted");
      throw closed_by(Interrupted(fmt::format("{}; {}", stop.what(), book_.last_good())), progress);
    } catch (const StabilityError& error) {
      throw closed_by(StabilityError(fmt::format("{}; {}", error.what(), book_.last_good())), progress);
    } catch (const std::exception& error) {
      closed_by(error, progress);
      throw;
    }
  }

 private:
  /// Closes the record of the run that `error` has ended, and returns the error.
  template <class Error>
  const Error& closed_by(const Error& error, const Progress& progress) {
    book_.close_failed(simulation_.clock(), progress, error);
    return error;
  }

  void resume() {
    if (!options_.resume) return;
    const std::optional<Checkpoint> checkpoint = book_.latest_checkpoint();
    if (!checkpoint) {
      book_.begin_anew();
      notes_.push_back(
          fmt::format("note: {} has no checkpoint to continue from: the run begins at its first step", book_.path()));
      return;
    }
    for (const std::string& refused : checkpoint->refused()) notes_.push_back("warning: passed over: " + refused);
    simulation_.restore([&](StateList& state) { checkpoint->load(state); });
    if (simulation_.clock().step != checkpoint->step())
      throw FileError(checkpoint->path() + ": the checkpoint is of another step than it says");
    if (const std::string other = book_.go_on_from(*checkpoint); !other.empty()) notes_.push_back("warning: " + other);
    // the end that --steps has moved beyond that of the case stays
    const std::int64_t former = std::max(last_step(scene_), book_.former_last_step());
    if (!options_.steps) last_ = former;
    if (last_ < checkpoint->step())
      notes_.push_back(fmt::format("note: {} {}: the run is at step {} already",
                                   options_.steps ? "--steps" : "end at step", last_, checkpoint->step()));
    if (const std::string moved = moved_end(former, checkpoint->step()); !moved.empty()) {
      notes_.push_back("note: " + moved);
      book_.record().events.push_back(fmt::format("step {}, {}", checkpoint->step(), moved));
    }
    last_ = std::max(last_, checkpoint->step());
    resumed_at_ = checkpoint->step();
  }

  /// A text that says from where to where the end of the run has been moved; empty where it has not, or where no step
  /// follows from it. `former`: its last step until now; `at`: the step that it has reached.
  std::string moved_end(std::int64_t former, std::int64_t at) const {
    const auto text = [](const TimeSection& time) {
      return time.end ? fmt::format("{:g} s", *time.end) : fmt::format("step {}", *time.steps);
    };
    const auto moved = [](const std::string& from, const std::string& to) {
      return from == to ? "" : fmt::format("the end of the run is moved from {} to {}", from, to);
    };
    const std::optional<TimeSection>& of_case = book_.former_end();
    if (options_.steps && last_ > last_step(scene_))
      return last_ > at
                 ? moved(of_case ? text(*of_case) : fmt::format("step {}", former), fmt::format("step {}", last_))
                 : "";
    return of_case && last_step(scene_) > at ? moved(text(*of_case), text(scene_.time)) : "";
  }

  /// Whether a stop is requested on any of the ranks.
  bool someone_is_to_stop() const {
    const Phase phase(ranks_, "agreement");
    return any_is_to_stop(ranks_);
  }

  /// A line on how the ranks share the lattice.
  std::string shares() const {
    const Partition& rows = simulation_.parts().geometry.split.rows();
    std::string text = fmt::format("ranks: {}, rows of the lattice from", ranks_.size());
    for (int r = 0; r < ranks_.size(); ++r) text += fmt::format(" {}", rows.first(r));
    text += fmt::format(", the largest share of the work {:.3f} of the mean", rows.imbalance());
    return takes_device_memory() ? text : text + "; messages go by way of the host";
  }

  void warn(Progress& progress) const {
    if (const std::string unlocked = book_.warning(); !unlocked.empty()) progress.note("warning: " + unlocked);
    if (!ranks_.alone()) progress.note(shares());
    for (const std::string& note : notes_) progress.note(note);
    if (scene_.mechanics && scene_.mechanics->scaling_chosen) progress.note("note: " + mass_scaling_note(scene_));
    const Parts& parts = simulation_.parts();  // in a resumed run, pores may have opened since the start
    const FlowPaths paths = resumed_at_ ? find_flow_paths(scene_, parts.geometry, parts.units) : parts.paths;
    for (const std::string& warning : warnings_of(scene_, parts, paths)) progress.note("warning: " + warning);
    for (const Limit& limit : simulation_.limits())
      if (!limit.inside()) progress.note("warning: " + warning_of(limit));
  }

  /// Takes steps until the end. Throws Interrupted on a requested stop, after writing a checkpoint.
  void advance(Progress& progress) {
    RunFiles files(scene_, simulation_, book_.path(), columns_, resumed_at_);
    for (const std::string& lost : files.passed_over()) progress.note("warning: passed over: " + lost);
    if (ranks_.first() && resumed_at_ && files.rows() < book_.rows())
      progress.note(fmt::format("warning: {}/history.csv has lost rows: {} of {} up to step {} are left", book_.path(),
                                files.rows(), book_.rows(), *resumed_at_));
    std::vector<std::string>& events_so_far = book_.record().events;
    const auto tell = [&](const std::vector<std::string>& news) {
      for (const std::string& line : news) progress.note(line);
      events_so_far.insert(events_so_far.end(), news.begin(), news.end());
    };
    if (!resumed_at_) {
      simulation_.begin();
      tell(Events::of_the_start(simulation_));
      files.write_snapshot();
      files.write_row();
    }
    Events events(simulation_, events_so_far, Events::runs_backwards(scene_));
    CarriedSteps carried(scene_, events_so_far);
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
      if (write_now || save) book_.require_ours();
      if (write_now) {
        const Phase phase(ranks_, "files");
        files.write_snapshot();
      }
      if (row) {
        const std::vector<HistoryValue> values = files.write_row();
        tell(events.look_at_row(simulation_, values));
        tell(carried.look_at_row(clock, values));
      }
      if (save) {
        files.sync_rows();
        book_.save(simulation_, files.rows(), progress);
      }
      progress.update(step, simulation_.updates_per_step(), clock.ahead);
      if (stop && !ended()) throw Interrupted(stop_reason());
    }
    tell(events.sum_up(simulation_));
    if (!ranks_.alone())
      for (const std::string& line : traffic_table(ranks_, simulation_.clock().step - book_.record().first_step))
        progress.note(line);
  }

  /// Whether the last step is done, or the rock has reached its final age.
  bool ended() const {
    const Clock& clock = simulation_.clock();
    return clock.step >= last_ || (clock.ahead > 0 && scene_.time.end && clock.time() >= *scene_.time.end);
  }

  const Scene& scene_;
  const RunOptions& options_;
  Ranks ranks_;
  RunBook book_;
  std::int64_t last_;
  Simulation simulation_;
  std::vector<std::string> columns_;  ///< of the history
  std::vector<std::string> notes_;    ///< to be shown when the log is open
  std::optional<std::int64_t> resumed_at_;
};

}  // namespace

void run_case(const Scene& scene, const RunOptions& options) {
  Run(scene, options)();
}

}  // namespace vug
