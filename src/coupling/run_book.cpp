#include "coupling/run_book.hpp"

#include "base/require.hpp"
#include "io/later_end.hpp"
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

/// The end of the run in the folder `path`, which is of another text of the case. Throws InputError where more differs
/// than the end, or where that is earlier now.
TimeSection end_of_the_run(const std::string& path, const RunSummary& held, const Scene& scene,
                           const RunRecord& record) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(fmt::format("{}: holds a run of another case, which this one cannot continue: {}", path, what));
  };
  for (const InputFile& input : record.inputs)
    if (held.inputs.find(input.hash) == std::string::npos) refuse(input.path + " has changed since");
  const RunOrigin origin = read_run_origin(path);
  const std::optional<TimeSection> before = time_of_same_case(scene, origin.case_text, origin.overrides);
  if (!before) refuse("the text of the case or a --set differs");
  if (scene.time.end ? *scene.time.end < *before->end : *scene.time.steps < *before->steps)
    refuse("its end is later; --steps stops it earlier");
  return *before;
}

/// "vug 0.1.0 (commit 8b0c4f9, GCC 12.2.0, OpenMP)", of a RunRecord or a RunOrigin.
template <class Origin>
std::string program_of(const Origin& of) {
  return fmt::format("vug {} (commit {}, {}, {})", of.version, of.commit, of.compiler, of.backend);
}

}  // namespace

RunBook::RunBook(const Scene& scene, const RunOptions& options)
    : options_(options),
      recorded_(scene, options.directory, use_of(options),
                "--resume continues it, --overwrite replaces it, -o DIR leaves it alone", options.ranks.first()),
      owner_(owner(scene)) {
  record().ranks = options.ranks.size();
}

/// The case and this run, or the run that it continues. Throws InputError where that run is of another case; nothing is
/// changed then.
CheckpointOwner RunBook::owner(const Scene& scene) {
  const std::string hash = case_hash(record().case_text, record().overrides, record().inputs);
  if (!options_.resume) return {hash, record().run};
  const RunFolder* folder = recorded_.folder();
  if (!folder || !folder->held()) return {hash, ""};
  const RunSummary& held = *folder->held();
  if (held.case_hash != hash) former_end_ = end_of_the_run(path(), held, scene, record());
  record().run = held.run;
  return {hash, held.run};
}

std::optional<Checkpoint> RunBook::latest_checkpoint() const {
  const Ranks& ranks = options_.ranks;
  std::optional<Checkpoint> found;
  // of a run whose name is known, any: those from before its end was moved have the hash of the case as it was then
  if (ranks.first())
    found = Checkpoint::latest(checkpoints(), owner_.run.empty() ? owner_ : CheckpointOwner{"", owner_.run});
  const std::string path = ranks.told(found ? found->path() : "");
  if (!ranks.first() && !path.empty()) found = Checkpoint::open(path, {});
  return found;
}

std::int64_t RunBook::former_last_step() const {
  const RunFolder* folder = recorded_.folder();
  const bool counts = folder && folder->held() && !former_end_;
  const std::string last = options_.ranks.told(counts ? folder->held()->last_step : "");
  return std::strtoll(last.c_str(), nullptr, 10);
}

std::string RunBook::go_on_from(const Checkpoint& checkpoint) {
  RunRecord& record = recorded_.record();
  owner_.run = record.run = checkpoint.run();
  record.last_checkpoint = record.first_step = record.steps = checkpoint.step();
  if (checkpoint.holds(history_rows)) checkpoint.load(own_state());
  const RunFolder* folder = recorded_.folder();
  if (!folder || !folder->held() || folder->held()->run != record.run) return "";
  record.events = folder->held()->events_until(checkpoint.step());
  record.wall_time = std::strtod(folder->held()->wall_time.c_str(), nullptr);
  const std::string now = program_of(record), before = program_of(read_run_origin(path()));
  if (now == before) return "";
  record.events.push_back(fmt::format("step {}, resumed with {}, before by {}", checkpoint.step(), now, before));
  return record.events.back();
}

/// What a checkpoint contains beside the state of the simulation.
StateList RunBook::own_state() {
  StateList list;
  list.add_value(history_rows, rows_, {0, most_steps});
  return list;
}

void RunBook::begin_anew() {
  if (recorded_.folder()) recorded_.folder()->require_dispensable();
  owner_.run = record().run;
}

void RunBook::open(std::optional<std::int64_t> last_step) {
  if (last_step) record().last_step = *last_step;
  recorded_.begin(options_.resume && !record().last_checkpoint);
}

/// The first rank writes the checkpoint; the others take part because saving a block may need all ranks.
void RunBook::save(Simulation& simulation, std::int64_t rows, const Progress& progress) {
  const Ranks& ranks = options_.ranks;
  const Phase phase(ranks, "files");
  rows_ = rows;
  StateList state = simulation.state();
  for (const StateBlock& block : own_state().blocks) state.add(block);
  const Clock& clock = simulation.clock();
  note(clock, progress);
  recorded_.write();  // first, so that a run that continues from here finds the events until then
  if (ranks.first())
    write_checkpoint(checkpoints(), state, clock.step, clock.time(), owner_);
  else
    for (const StateBlock& block : state.blocks) block.save([](std::span<const std::byte>) {});
  const bool first = !record().last_checkpoint;
  record().last_checkpoint = clock.step;
  if (first) recorded_.write();  // records that there was one, in case it is lost
  ranks.most(0);                 // no rank ends before it is written
}

std::string RunBook::last_good() const {
  const std::optional<std::int64_t>& last = recorded_.record().last_checkpoint;
  if (!last) return "there is no checkpoint yet";
  return fmt::format("the last good state is the checkpoint of step {} in {}", *last, checkpoints());
}

void RunBook::close_done(const Clock& clock, const Progress& progress) {
  note(clock, progress);
  recorded_.close_done("reached the last step");
}

void RunBook::close_failed(const Clock& clock, const Progress& progress, const std::exception& error) {
  note(clock, progress);
  recorded_.close_failed(error);
}

/// Notes the present step, time and speed in the record.
void RunBook::note(const Clock& clock, const Progress& progress) {
  record().steps = clock.step;
  record().simulated_time = clock.time();
  record().mlups = progress.mlups();
}

}  // namespace vug
