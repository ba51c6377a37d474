#include "command_line.hpp"

#include "host/threads.hpp"

#include <charconv>
#include <cmath>

namespace vug {

namespace {

/// Error message for a text that is not a whole number, 0 or more; else empty.
std::string fault_of_count(const std::string& text) {
  std::int64_t steps = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), steps);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && steps >= 0 ? "" : "must be a whole number, 0 or more";
}

/// Error message for a text that is not a finite number above 0; else empty.
std::string fault_of_positive(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool number = error == std::errc() && end == text.data() + text.size();
  return number && value > 0 && std::isfinite(value) ? "" : "must be a number above 0";
}

/// Error message for a text that is not a strength of rock in MPa; else empty.
std::string fault_of_strength(const std::string& text) {
  const std::string fault = fault_of_positive(text);
  if (!fault.empty()) return fault;
  return std::stod(text) <= 1e4 ? "" : "is in MPa: at most 10000 expected";
}

void take_case(CLI::App& command, CommandLine& line, const char* what = "Case file (TOML)") {
  command.add_option("case", line.case_file, what)->required();
}

void take_overrides(CLI::App& command, CommandLine& line) {
  command.add_option("--set", line.overrides, "Override a key: table.key=value")->allow_extra_args(false);
}

void take_threads(CLI::App& command, CommandLine& line) {
  command
      .add_option("--threads", line.threads,
                  "Threads (default: KOKKOS_NUM_THREADS, OMP_NUM_THREADS, else one per idle processor)")
      ->check(CLI::Range(1, most_threads));
}

void take_quiet(CLI::App& command, CommandLine& line) {
  command.add_flag("--quiet", line.quiet, "No progress, only warnings");
}

void describe_run(CLI::App& app, CommandLine& line) {
  line.run = app.add_subcommand("run", "Run a case");
  take_case(*line.run, line);
  line.run->add_option("-o,--output", line.directory, "Run directory (default: runs/<name of the case file>)");
  take_overrides(*line.run, line);
  line.run->add_option("--steps", line.steps, "Stop after this many lattice steps, also beyond the end of the case")
      ->check(fault_of_count);
  take_threads(*line.run, line);
  CLI::Option* resume =
      line.run->add_flag("--resume", line.resume, "Continue from the newest checkpoint of the run directory, if any");
  line.run->add_flag("--overwrite", line.overwrite, "Replace the run that the run directory holds")->excludes(resume);
  line.run->add_flag("--error-bars", line.error_bars,
                     "Run coarser lattices as well (rock: finer intervals) and tell how wrong the numbers are");
  take_quiet(*line.run, line);
}

void describe_check(CLI::App& app, CommandLine& line) {
  line.check = app.add_subcommand("check", "Validate a case and print its derived numbers, memory and cost");
  take_case(*line.check, line);
  take_overrides(*line.check, line);
  take_threads(*line.check, line);
  CLI::Option* const json = line.check->add_flag("--json", line.json, "Machine-readable");
  line.check->add_option("--preview", line.preview, "Draw rock and pores into this PNG file");
  line.check->add_flag("--schedule", line.schedule, "List what a lattice step does, what it reads and what it writes")
      ->excludes(json);
  line.check->add_flag("--explain", line.explain, "List what the numbers of the case are on its lattice")
      ->excludes(json);
}

void describe_lab(CLI::App& app, CommandLine& line) {
  line.lab = app.add_subcommand("lab", "Run the laboratory test of a case: compression, tension, splitting, heat");
  take_case(*line.lab, line, "Case file (TOML) with [laboratory]");
  line.lab->add_option("-o,--output", line.directory, "Directory (default: runs/<name of the case file>)");
  take_overrides(*line.lab, line);
  line.lab
      ->add_option("--seeds", line.seeds, "Specimens that differ in the scatter of their bonds (default: 1, to fit 5)")
      ->check(CLI::Range(1, 1000));
  line.lab->add_option("--fit-cohesion", line.fit_cohesion, "Find the cohesion of this mean strength, MPa")
      ->check(fault_of_strength);
  take_threads(*line.lab, line);
  line.lab->add_flag("--overwrite", line.overwrite, "Replace the results that the directory holds");
  take_quiet(*line.lab, line);
}

void describe_sweep(CLI::App& app, CommandLine& line) {
  line.sweep = app.add_subcommand("sweep", "Run a study: many runs of a case that differ in some keys");
  line.sweep->add_option("study", line.study, "Study (TOML)")->required();
  line.sweep->add_option("-o,--output", line.directory, "Directory (default: runs/<name of the study>)");
  CLI::Option* const jobs =
      line.sweep->add_option("-j,--jobs", line.jobs, "Runs at once, each with one thread (default: one per processor)")
          ->check(CLI::Range(1, 4096));
  CLI::Option* const go_on = line.sweep->add_flag("--resume", line.resume, "Continue what the directory holds");
  CLI::Option* const batch =
      line.sweep->add_option("--batch", line.batch, "Run nothing; print a script for this batch system: slurm")
          ->check(CLI::IsMember({"slurm"}));
  CLI::Option* const member =
      line.sweep->add_option("--member", line.member, "Run only this one, counted from 0, in this process");
  CLI::Option* const table = line.sweep->add_flag(
      "--table", line.only_table, "Run nothing; make table.csv and failures.csv of what the directory holds");
  for (CLI::Option* const other : {jobs, go_on, batch, member}) table->excludes(other);
  take_quiet(*line.sweep, line);
}

void describe_tune(CLI::App& app, CommandLine& line) {
  line.tune =
      app.add_subcommand("tune", "Find the fastest settings that stay within a tolerance at the beginning of a case");
  take_case(*line.tune, line);
  line.tune
      ->add_option("--tolerance", line.tolerance,
                   "Largest error, over the largest change of its column (default: 1e-3)")
      ->check(fault_of_positive);
  line.tune
      ->add_option("--steps", line.steps, "Lattice steps of each pilot (default: a twentieth of the run, 800 to 8000)")
      ->check(fault_of_count);
  line.tune
      ->add_option("--columns", line.columns, "Columns of history.csv to hold to (default: every amount that changes)")
      ->delimiter(',')
      ->allow_extra_args(false);
  take_overrides(*line.tune, line);
  take_threads(*line.tune, line);
  take_quiet(*line.tune, line);
}

void describe_watch(CLI::App& app, CommandLine& line) {
  line.watch = app.add_subcommand("watch", "Follow a run under way: how far it is, and the course of its numbers");
  line.watch->add_option("directory", line.directory, "Run directory")->required();
  line.watch->add_option("--columns", line.columns, "Columns of history.csv (default: those that change)")
      ->delimiter(',')
      ->allow_extra_args(false);
  line.watch->add_flag("--once", line.once, "Only now (also when the output is no terminal)");
}

void describe_report(CLI::App& app, CommandLine& line) {
  line.report = app.add_subcommand(
      "report",
      "Bundle a run for somebody else: case, version, last good checkpoint, a script that runs its end again");
  line.report->add_option("directory", line.directory, "Run directory")->required();
  line.report->add_option("-o,--output", line.bundle, "Folder to make (default: <run directory>-report)");
}

}  // namespace

void describe(CLI::App& app, CommandLine& line) {
  app.require_subcommand(0, 1);
  app.add_flag("--version", line.version, "Version, commit and back end");
  app.add_flag("--cite", line.cite, "How to cite vug");
  app.set_help_all_flag("--help-all", "Help of all commands");
  describe_run(app, line);
  describe_check(app, line);
  describe_lab(app, line);
  line.info = app.add_subcommand("info", "Version, back ends, precisions, device");
  line.info->add_flag("--json", line.json, "Machine-readable");
  describe_sweep(app, line);
  line.start = app.add_subcommand(
      "new", "Write a case to begin with: channel, reactive_channel, heated_channel, rock, fracture");
  line.start->add_option("template", line.name, "Name of the template")->required();
  line.start->add_option("file", line.case_file, "File to write (default: <name of the template>.toml)");
  line.schema = app.add_subcommand("schema", "JSON schema of the case file, for editors");
  line.completion = app.add_subcommand("completion", "Completion for a shell: bash, zsh, fish");
  line.completion->add_option("shell", line.name, "Name of the shell")->required();
  describe_tune(app, line);
  describe_watch(app, line);
  describe_report(app, line);
  line.man = app.add_subcommand("man", "Manual page, for man -l");
}

}  // namespace vug
