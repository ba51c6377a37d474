#include "front/report.hpp"

#include "base/require.hpp"
#include "front/new_folder.hpp"
#include "host/interruption.hpp"
#include "io/checkpoint.hpp"
#include "io/detail/checkpoint_names.hpp"
#include "io/detail/files.hpp"
#include "io/history_reader.hpp"
#include "io/run_summary.hpp"
#include "io/shell_word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

namespace vug {

namespace {

namespace fs = std::filesystem;

/// Paths of the case and its files in the bundle, chosen so that the paths in the case stay valid.
struct CasePlaces {
  fs::path file;                 ///< the case
  std::vector<fs::path> inputs;  ///< empty for a file that the case names by an absolute path
};

CasePlaces places_of(const RunOrigin& origin) {
  const fs::path file(origin.case_path), folder = file.parent_path();
  CasePlaces places;
  std::ptrdiff_t above = 0;
  for (const InputFile& input : origin.inputs) {
    const auto names = [&](const std::string& text) { return text.find(input.path) != std::string::npos; };
    const bool whole =
        fs::path(input.path).is_absolute() &&
        (names(origin.case_text) || std::any_of(origin.overrides.begin(), origin.overrides.end(), names));
    places.inputs.push_back(whole ? fs::path()
                                  : fs::path(input.path).lexically_relative(folder.empty() ? "." : folder));
    above = std::max(above, std::count(places.inputs.back().begin(), places.inputs.back().end(), fs::path("..")));
  }
  fs::path home("case");
  for (std::ptrdiff_t k = 0; k < above; ++k) home /= "case";
  places.file = home / file.filename();
  for (fs::path& input : places.inputs)
    if (!input.empty()) input = (home / input).lexically_normal();
  return places;
}

/// The last step of the run; for one that was killed or is under way, the last one in its history.
std::int64_t step_reached(const std::string& path, const RunSummary& summary) {
  const History history = read_history(path);
  if (history.rows() == 0 && std::atoll(summary.steps.c_str()) > 0)
    throw InputError(path + ": has no row to compare with, though the run has taken steps");
  const int steps = history.find("step_1");
  const double last_row = steps >= 0 && history.rows() > 0 ? history.values[steps].back() : 0;
  return std::max<std::int64_t>(std::atoll(summary.steps.c_str()), static_cast<std::int64_t>(last_row));
}

/// The newest undamaged checkpoint before a step.
std::optional<Checkpoint> checkpoint_before(std::int64_t step, const std::string& directory,
                                            const RunSummary& summary) {
  for (const fs::path& path : detail::checkpoints(directory + "/checkpoint")) try {
      Checkpoint checkpoint = Checkpoint::open(path.string(), {"", summary.run});
      if (checkpoint.step() < step) return checkpoint;
    } catch (const FileError&) {
      continue;  // damaged, of another run, or just replaced by a newer one
    }
  return std::nullopt;
}

/// Information on a run for the bundle, and the start of its replay.
struct Told {
  RunSummary summary;
  RunOrigin origin;
  CasePlaces places;
  std::int64_t reached;
  std::optional<Checkpoint> checkpoint;

  std::string beginning() const {
    return checkpoint ? fmt::format("the checkpoint of step {}", checkpoint->step())
                      : "the first step: there is no checkpoint before its end";
  }
  std::string replay_command() const {
    std::string command = "\"$vug\" run " + shell_word(places.file.string());
    for (const std::string& entry : origin.overrides) command += " --set " + shell_word(entry);
    return command + fmt::format(" --steps {} -o replayed{}", reached, checkpoint ? " --resume" : "");
  }
  /// Exit codes that a replay may have, as a pattern of the shell's `case`. The replay of a run that was stopped, or
  /// ran out of memory, may reach the end.
  std::string codes() const { return summary.status == "diverged" ? summary.exit_code : "0 | " + summary.exit_code; }
};

/// Compares histories only up to the length of the run's: the last row of a run that was killed may be incomplete, and
/// the replay ends with an additional row.
constexpr const char* replay_script = R"sh(#!/bin/sh
# Runs the last stretch of a run of vug again, into the folder `replayed` beside this file, and compares its history with
# the run's, byte by byte. Another program than vug in PATH: VUG=/path/to/vug ./replay
set -eu
cd "$(dirname "$0")"
vug=${{VUG:-vug}}
if [ -e replayed ]; then echo "replayed: is there already; remove it first" >&2; exit 2; fi
echo "the run is of vug {version} (commit {commit}, {backend}); this is $("$vug" --version)"
{prepare}code=0
{command} || code=$?
case $code in
  {codes}) ;;
  *) echo "exit code $code; the run's was {exit_code} ({status})" >&2; exit 1 ;;
esac
size=$(wc -c < run/history.csv)
if head -c "$size" replayed/history.csv | cmp - run/history.csv; then
  echo "the same history, byte for byte"
else
  echo "another history" >&2
  exit 1
fi
)sh";

constexpr const char* read_me = R"(A run of vug, to be looked at by somebody else

{status}, step {steps}
{reason}
started        {started}
program        vug {version}, commit {commit}
compiler       {compiler}
back end       {backend}, {device}
case           {case_file}
begins from    {beginning}

./replay runs the last stretch again and compares the histories; the same program gives the same bytes on any number of
threads. run/run.json has everything that the run says of itself.
)";

std::string size_text(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) bytes += entry.file_size();
  return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20));
}

/// Reason why a file of the case cannot be included; empty if it can.
std::string what_hinders(const InputFile& input, const fs::path& place) {
  if (place.empty()) return "is named by its whole path: send it apart";
  try {
    return digest_of_file(input.path).hash == input.hash ? "" : "has changed since the run";
  } catch (const std::runtime_error&) {
    return "cannot be read from here: call from where the run was called";
  }
}

/// Copies the case and its files; returns a warning for each file that is not included.
std::string copy_case(const Told& told, const NewFolder& folder) {
  std::string warnings;
  folder.write(told.places.file, told.origin.case_text);
  for (std::size_t i = 0; i < told.origin.inputs.size(); ++i) {
    const InputFile& input = told.origin.inputs[i];
    const std::string hindrance = what_hinders(input, told.places.inputs[i]);
    if (hindrance.empty())
      fs::copy_file(input.path, folder.place(told.places.inputs[i]));
    else
      warnings += fmt::format("warning: {}: not in the bundle: {}\n", input.path, hindrance);
  }
  return warnings;
}

/// Copies the whole rows of the history, to which a run under way adds; returns the path of the copy.
std::string copy_history(const std::string& directory, const NewFolder& folder) {
  const std::string text = detail::read_file(directory + "/history.csv");
  folder.write("run/history.csv", text.substr(0, text.rfind('\n') + 1));
  return folder.place("run/history.csv").string();
}

/// Copies the newest checkpoint before a step; a run under way may remove it meanwhile, and has a newer one then.
std::optional<Checkpoint> copy_checkpoint(std::int64_t step, const std::string& directory, const RunSummary& summary,
                                          const NewFolder& folder) {
  for (int attempt = 0; attempt < 3; ++attempt) {
    const std::optional<Checkpoint> found = checkpoint_before(step, directory, summary);
    if (!found) break;
    const fs::path path(found->path());
    std::error_code gone;
    fs::copy_file(path, folder.place(fs::path("run/checkpoint") / path.filename()), gone);
    if (!gone) return found;
  }
  return std::nullopt;
}

void write_texts(const Told& told, const NewFolder& folder) {
  using fmt::arg;
  const RunOrigin& origin = told.origin;
  folder.write("replay", fmt::format(replay_script, arg("version", origin.version), arg("commit", origin.commit),
                                     arg("backend", origin.backend), arg("status", told.summary.status),
                                     arg("prepare", told.checkpoint ? "cp -R run replayed\n" : ""),
                                     arg("exit_code", told.summary.exit_code), arg("codes", told.codes()),
                                     arg("command", told.replay_command())));
  fs::permissions(folder.place("replay"), fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                  fs::perm_options::add);
  folder.write("README.txt", fmt::format(read_me, arg("status", told.summary.status), arg("steps", told.reached),
                                         arg("reason", told.summary.exit_reason), arg("started", told.summary.started),
                                         arg("version", origin.version), arg("commit", origin.commit),
                                         arg("compiler", origin.compiler), arg("backend", origin.backend),
                                         arg("device", origin.device), arg("case_file", told.places.file.string()),
                                         arg("beginning", told.beginning())));
}

}  // namespace

std::string report_directory(const std::string& directory) {
  fs::path path = fs::path(directory).lexically_normal();
  if (const fs::path last = path.filename(); last == "." || last == "..") path = fs::absolute(path).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).string() + "-report";
}

std::string report_run(const std::string& directory, const std::string& bundle) {
  const std::optional<RunSummary> summary = read_run_summary(directory);
  if (!summary) throw InputError(directory + ": holds no run (it has no run.json)");
  if (!fs::exists(directory + "/history.csv"))
    throw InputError(directory +
                     ": has no history.csv to compare with (a laboratory test, or a run that ended before "
                     "its first step: send its case file)");
  const RunOrigin origin = read_run_origin(directory);
  const StopsInOrder in_order;  // so that nothing is left of a bundle that is not complete
  NewFolder folder(bundle);
  fs::copy_file(fs::path(directory) / "run.json", folder.place("run/run.json"));
  const std::int64_t reached = step_reached(copy_history(directory, folder), *summary);
  const Told told{*summary, origin, places_of(origin), reached, copy_checkpoint(reached, directory, *summary, folder)};
  throw_if_stop_requested();
  const std::string warnings = copy_case(told, folder);
  write_texts(told, folder);
  throw_if_stop_requested();
  folder.commit();
  return warnings + fmt::format("{}: {}, replays from {}\n{}/replay runs it again; to send it: tar -czf {} {}\n",
                                bundle, size_text(bundle), told.beginning(), shell_word(bundle),
                                shell_word(bundle + ".tar.gz"), shell_word(bundle));
}

}  // namespace vug
