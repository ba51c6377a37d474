#include "coupling/run_book.hpp"

#include "coupling/run_directory.hpp"
#include "kernels/base/require.hpp"
#include "ranks/traffic.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <span>

namespace vug {

namespace {

const std::string history_rows = "history/rows";

RunFolder::Use use_of(const RunOptions& options) {
  if (options.resume) return RunFolder::Use::resume;
  return options.overwrite ? RunFolder::Use::overwrite : RunFolder::Use::fresh;
}

std::optional<RunFolder> folder_of_the_writer(const RunOptions& options, const std::string& path) {
  if (!options.ranks.first()) return std::nullopt;
  return std::optional<RunFolder>(std::in_place, path, use_of(options),
                                  "--resume continues it, --overwrite replaces it, -o DIR leaves it alone");
}

/// Text on what differs between the case and the run that `held` describes: an input file, else the case itself.
std::string what_has_changed(const RunRecord& record, const RunSummary& held) {
  for (const InputFile& input : record.inputs)
    if (held.inputs.find(input.hash) == std::string::npos) return input.path + " has changed since";
  return "the text of the case or a --set differs";
}

/// "vug 0.1.0 (commit 8b0c4f9, GCC 12.2.0, OpenMP)", of a RunRecord or a RunOrigin.
template <class Origin>
std::string program_of(const Origin& of) {
  return fmt::format("vug {} (commit {}, {}, {})", of.version, of.commit, of.compiler, of.backend);
}

}  // namespace

RunBook::RunBook(const Scene& scene, const RunOptions& options)
    : options_(options),
      path_(run_directory(scene, options.directory)),
      folder_(folder_of_the_writer(options, path_)),
      record_(first_record(scene)),
      owner_(owner()) {
  record_.ranks = options.ranks.size();
}

/// The case and this run, or the run that it continues. Throws InputError where that run is of another case; nothing is
/// changed then.
CheckpointOwner RunBook::owner() {
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

std::string RunBook::warning() const {
  return folder_ ? folder_->warning() : "";
}

std::optional<Checkpoint> RunBook::latest_checkpoint() const {
  const Ranks& ranks = options_.ranks;
  std::optional<Checkpoint> found;
  if (ranks.first()) found = Checkpoint::latest(checkpoints(), owner_);
  const std::string path = ranks.told(found ? found->path() : "");
  if (!ranks.first() && !path.empty()) found = Checkpoint::open(path, owner_);
  return found;
}

std::string RunBook::go_on_from(const Checkpoint& checkpoint) {
  owner_.run = record_.run = checkpoint.run();
  record_.last_checkpoint = record_.first_step = record_.steps = checkpoint.step();
  if (checkpoint.holds(history_rows)) checkpoint.load(own_state());
  if (!folder_ || !folder_->held() || folder_->held()->run != record_.run) return "";
  record_.events = folder_->held()->events_until(checkpoint.step());
  earlier_time_ = record_.wall_time = std::strtod(folder_->held()->wall_time.c_str(), nullptr);
  const std::string now = program_of(record_), before = program_of(read_run_origin(path_));
  if (now == before) return "";
  record_.events.push_back(fmt::format("step {}, resumed with {}, before by {}", checkpoint.step(), now, before));
  return record_.events.back();
}

/// What a checkpoint contains beside the state of the simulation.
StateList RunBook::own_state() {
  StateList list;
  list.add_value(history_rows, rows_, {0, most_steps});
  return list;
}

void RunBook::begin_anew() {
  if (folder_) folder_->require_dispensable();
  owner_.run = record_.run;
}

void RunBook::open(std::optional<std::int64_t> last_step) {
  if (!folder_) return;
  folder_->take();
  if (options_.resume && !record_.last_checkpoint) folder_->clear();
  if (last_step) record_.last_step = *last_step;
  write_run_record(path_, record_);
}

void RunBook::require_ours() const {
  if (folder_ && !folder_->is_ours())
    throw FileError(path_ + ": was removed or replaced while the run wrote there; nothing more is written to it");
}

/// The first rank writes the checkpoint; the others take part because saving a block may need all ranks.
void RunBook::save(Simulation& simulation, std::int64_t rows, const Progress& progress) {
  const Ranks& ranks = options_.ranks;
  const Phase phase(ranks, "files");
  rows_ = rows;
  StateList state = simulation.state();
  for (const StateBlock& block : own_state().blocks) state.add(block);
  const Clock& clock = simulation.clock();
  if (folder_) write(clock, progress);  // first, so that a run that continues from here finds the events until then
  if (ranks.first())
    write_checkpoint(checkpoints(), state, clock.step, clock.time(), owner_);
  else
    for (const StateBlock& block : state.blocks) block.save([](std::span<const std::byte>) {});
  const bool first = !record_.last_checkpoint;
  record_.last_checkpoint = clock.step;
  if (folder_ && first) write_run_record(path_, record_);  // records that there was one, in case it is lost
  ranks.most(0);                                           // no rank ends before it is written
}

std::string RunBook::last_good() const {
  if (!record_.last_checkpoint) return "there is no checkpoint yet";
  return fmt::format("the last good state is the checkpoint of step {} in {}", *record_.last_checkpoint, checkpoints());
}

void RunBook::close_done(const Clock& clock, const Progress& progress) {
  note_end(record_, "done", "reached the last step", done);
  write_end(clock, progress);
}

void RunBook::close_early(const Clock& clock, const Progress& progress, const std::string& status,
                          const std::string& reason, ExitCode code) {
  note_end(record_, status, reason, code);
  try_to_write_end(clock, progress);
}

void RunBook::close_failed(const Clock& clock, const Progress& progress, const std::exception& error) {
  reserve_.reset();
  note_failure(record_, error);
  try_to_write_end(clock, progress);
}

void RunBook::try_to_write_end(const Clock& clock, const Progress& progress) {
  try {
    write_end(clock, progress);
  } catch (const FileError&) {
    // where results cannot be written, the record cannot either; the first error is the one to report
  }
}

void RunBook::write_end(const Clock& clock, const Progress& progress) {
  if (!folder_ || !folder_->is_ours()) return;
  record_.ended = utc_now();
  write(clock, progress);
}

/// Writes the record with the present step and times.
void RunBook::write(const Clock& clock, const Progress& progress) {
  record_.steps = clock.step;
  record_.simulated_time = clock.time();
  record_.wall_time = earlier_time_ + progress.wall_time();
  record_.mlups = progress.mlups();
  write_run_record(path_, record_);
}

}  // namespace vug
