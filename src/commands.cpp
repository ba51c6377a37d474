#include "commands.hpp"

#include "base/require.hpp"
#include "coupling/check.hpp"
#include "coupling/error_bars.hpp"
#include "coupling/laboratory_run.hpp"
#include "coupling/program_info.hpp"
#include "coupling/run.hpp"
#include "coupling/tuning.hpp"
#include "front/completion.hpp"
#include "front/man_page.hpp"
#include "front/report.hpp"
#include "front/schema.hpp"
#include "front/templates.hpp"
#include "front/watch.hpp"
#include "host/interruption.hpp"
#include "host/this_process.hpp"
#include "io/json_text.hpp"
#include "io/run_record.hpp"
#include "process.hpp"
#include "ranks/mpi.hpp"
#include "study/sweep.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <ostream>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

namespace vug {

namespace {

int info_command(const CommandLine& line, const Ranks& ranks) {
  const BuildInfo build = build_info();
  const std::vector<std::string> places = ranks.told_by_all(machine_name() + ": " + build.device);
  if (!ranks.first()) return done;
  const auto quoted = [&](const std::string& text) { return line.json ? json_string(text) : text; };
  std::vector<std::string> names;
  for (const std::string& place : places) names.push_back(quoted(place));
  std::string lines;
  for (std::size_t r = 0; !ranks.alone() && r < places.size(); ++r)
    lines += fmt::format("{:10} {}\n", fmt::format("rank {}", r), places[r]);
  constexpr const char* json =
      R"({{"version": {}, "commit": {}, "compiler": {}, "backend": {}, "device": {}, "threads": {}, )"
      R"("mpi": {}, "ranks": {}, "places": [{}], "precisions": ["single", "double"]}})"
      "\n";
  constexpr const char* text =
      "vug {} ({})\ncompiler   {}\nback end   {}\ndevice     {}\nthreads    {}\nmpi        {}\nranks      {}\n{}"
      "precisions single, double\n";
  print(fmt::format(fmt::runtime(line.json ? json : text), quoted(build.version), quoted(build.commit),
                    quoted(build.compiler), quoted(build.backend), quoted(build.device), build.threads,
                    quoted(mpi_library()), ranks.size(),
                    line.json ? fmt::format("{}", fmt::join(names, ", ")) : lines));
  return done;
}

Scene scene_of(const CommandLine& line) {
  Scene scene = read_scene(line.case_file, line.overrides);
  if (!line.remark.empty()) scene.warnings.push_back(line.remark);  // not reported for an invalid case
  return scene;
}

/// Reads a case that must have, or must not have, the table [laboratory]; throws InputError otherwise.
Scene scene_of(const CommandLine& line, bool laboratory) {
  Scene scene = scene_of(line);
  if (laboratory && !scene.laboratory)
    throw InputError(line.case_file + ": has no table [laboratory]; `vug run` runs it");
  if (!laboratory && scene.laboratory)
    throw InputError(line.case_file + ": describes a laboratory test; `vug lab` runs it");
  return scene;
}

int lab_command(const CommandLine& line, std::ostream& log) {
  const Scene scene = scene_of(line, true);
  LaboratoryOptions options;
  options.directory = line.directory;
  options.seeds = line.seeds > 0 ? line.seeds : line.fit_cohesion ? 5 : 1;
  if (line.fit_cohesion) options.fit_strength = 1e6 * *line.fit_cohesion;
  options.progress = line.quiet ? nullptr : &log;
  options.warnings = &log;
  options.overwrite = line.overwrite;
  print(run_laboratory(scene, options));
  return done;
}

int check_command(const CommandLine& line) {
  const Scene scene = scene_of(line);
  if ((line.schedule || line.explain) && scene.laboratory)
    throw InputError("--schedule and --explain are of a lattice, and a laboratory test has none");
  const CheckReport report = check_case(scene, line.preview);
  print(line.json ? to_json(report) : to_text(report));
  if (line.schedule) print('\n' + to_text(report.schedule));
  if (line.explain) print('\n' + report.explanation);
  return done;
}

int run_command(const CommandLine& line, const Ranks& ranks, std::ostream& log) {
  const Scene scene = scene_of(line, false);
  RunOptions options;
  options.directory = line.directory;
  options.steps = line.steps;
  options.resume = line.resume;
  options.overwrite = line.overwrite;
  options.terminal = isatty(STDERR_FILENO) != 0;
  options.progress = line.quiet || !ranks.first() ? nullptr : &log;
  options.warnings = ranks.first() ? &log : nullptr;
  options.ranks = ranks;
  if (line.error_bars)
    print(run_with_error_bars(scene, options));
  else
    run_case(scene, options);
  return done;
}

int tune_command(const CommandLine& line, std::ostream& log) {
  TuningOptions options;
  options.tolerance = line.tolerance;
  options.steps = line.steps;
  options.columns = line.columns;
  options.progress = line.quiet ? nullptr : &log;
  print(to_text(tune(scene_of(line, false), options), line.tolerance));
  return done;
}

int sweep_command(const CommandLine& line, std::ostream& log) {
  SweepOptions options;
  options.directory = line.directory;
  options.at_once = line.jobs;
  options.resume = line.resume;
  options.only_table = line.only_table;
  options.progress = line.quiet ? nullptr : &log;
  options.warnings = &log;
  unsetenv("SLURM_STEP_NUM_TASKS");  // each of its runs is one process, whatever srun has started
  if (!line.batch.empty()) {
    print(slurm_script(line.study, options));
    return done;
  }
  if (line.member) become_member(line.study, options, *line.member);
  const int failed = sweep(line.study, options);
  if (failed > 0) complain(fmt::format("vug: {} of the runs are not done: failures.csv says why", failed));
  return failed > 0 ? diverged : done;
}

int watch_command(const CommandLine& line) {
  say_when_ended("no longer watching; a run goes on");
  winsize window{};
  const bool terminal = isatty(STDOUT_FILENO) != 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0;
  WatchView view{80, 40, line.columns};
  if (terminal && window.ws_col > 0) view = {window.ws_col, window.ws_row, line.columns};
  const bool once = line.once || !terminal;
  const auto show = [&](const std::string& text) { print(once ? text : "\x1b[H\x1b[2J" + text); };
  return watch(line.directory, view, once, show) ? done : diverged;
}

}  // namespace

std::optional<int> plain_command(const CLI::App& app, const CommandLine& line, std::ostream& log) {
  if (*line.sweep) return sweep_command(line, log);
  if (*line.watch) return watch_command(line);
  if (*line.start)
    print(new_case(line.name, line.case_file) + "\n");
  else if (*line.report)
    print(report_run(line.directory, line.bundle.empty() ? report_directory(line.directory) : line.bundle));
  else if (*line.schema)
    print(case_schema());
  else if (*line.completion)
    print(completion_script(app, line.name));
  else if (*line.man)
    print(man_page(app, VUG_VERSION));
  else if (line.version)
    print(version_line() + "\n");
  else if (line.cite)
    print(citation_text());
  else
    return std::nullopt;
  return done;
}

int computing_command(const CommandLine& line, const Ranks& ranks, std::ostream& log) {
  if (*line.info) return info_command(line, ranks);
  if (*line.check) return check_command(line);
  if (*line.lab) return lab_command(line, log);
  if (*line.tune) return tune_command(line, log);
  return run_command(line, ranks, log);
}

}  // namespace vug
