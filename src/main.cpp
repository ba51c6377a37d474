// The commands of vug: parse the command line, call, turn exceptions into exit codes.
#include "command_line.hpp"
#include "coupling/check.hpp"
#include "coupling/error_bars.hpp"
#include "coupling/laboratory_run.hpp"
#include "coupling/run.hpp"
#include "coupling/run_directory.hpp"
#include "coupling/tuning.hpp"
#include "front/completion.hpp"
#include "front/report.hpp"
#include "front/schema.hpp"
#include "front/short_waits.hpp"
#include "front/templates.hpp"
#include "front/watch.hpp"
#include "host/free_memory.hpp"
#include "host/interruption.hpp"
#include "host/memory.hpp"
#include "host/subnormals.hpp"
#include "host/threads.hpp"
#include "io/message.hpp"
#include "io/run_record.hpp"
#include "kernels/base/require.hpp"
#include "process.hpp"
#include "ranks/mpi.hpp"
#include "study/sweep.hpp"

#include <Kokkos_Core.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>
#include <vector>

namespace {

enum ExitCode { done = 0, invalid_input = 2, diverged = 3, file_failed = 4, out_of_memory = 5, interrupted = 130 };

using vug::CommandLine;

int info(const CommandLine& line, const vug::Ranks& ranks) {
  const vug::BuildInfo build = vug::build_info();
  const std::vector<std::string> places = ranks.told_by_all(vug::machine_name() + ": " + build.device);
  if (!ranks.first()) return done;
  std::string lines;
  for (std::size_t r = 0; !ranks.alone() && r < places.size(); ++r)
    lines += fmt::format("{:10} {}\n", fmt::format("rank {}", r), places[r]);
  constexpr const char* json =
      R"({{"version": "{}", "commit": "{}", "compiler": "{}", "backend": "{}", "device": "{}", "threads": {}, )"
      R"("mpi": "{}", "ranks": {}, "places": ["{}"], "precisions": ["single", "double"]}})"
      "\n";
  constexpr const char* text =
      "vug {} ({})\ncompiler   {}\nback end   {}\ndevice     {}\nthreads    {}\nmpi        {}\nranks      {}\n{}"
      "precisions single, double\n";
  vug::print(fmt::format(fmt::runtime(line.json ? json : text), build.version, build.commit, build.compiler,
                         build.backend, build.device, build.threads, vug::mpi_library(), ranks.size(),
                         line.json ? fmt::format("{}", fmt::join(places, "\", \"")) : lines));
  return done;
}

vug::Scene scene_of(const CommandLine& line) {
  vug::Scene scene = vug::read_scene(line.case_file, line.overrides);
  if (!line.remark.empty()) scene.warnings.push_back(line.remark);  // an invalid case is told alone
  return scene;
}

/// The scene of a case that has a [laboratory] or has none.
vug::Scene scene_of(const CommandLine& line, bool laboratory) {
  vug::Scene scene = scene_of(line);
  if (laboratory && !scene.laboratory)
    throw vug::InputError(line.case_file + ": has no table [laboratory]; `vug run` runs it");
  if (!laboratory && scene.laboratory)
    throw vug::InputError(line.case_file + ": describes a laboratory test; `vug lab` runs it");
  return scene;
}

int lab(const CommandLine& line) {
  const vug::Scene scene = scene_of(line, true);
  vug::LaboratoryOptions options;
  options.directory = line.directory;
  options.seeds = line.seeds > 0 ? line.seeds : line.fit_cohesion ? 5 : 1;
  if (line.fit_cohesion) options.fit_strength = 1e6 * *line.fit_cohesion;
  options.progress = line.quiet ? nullptr : &std::cerr;
  options.warnings = &std::cerr;
  options.overwrite = line.overwrite;
  vug::print(vug::run_laboratory(scene, options));
  return done;
}

int check(const CommandLine& line) {
  const vug::CheckReport report = vug::check_case(scene_of(line), line.preview);
  vug::print(line.json ? vug::to_json(report) : vug::to_text(report));
  if ((line.schedule || line.explain) && report.nx == 0)
    throw vug::InputError("--schedule and --explain are of a lattice, and a laboratory test has none");
  if (line.schedule) vug::print('\n' + vug::to_text(report.schedule));
  if (line.explain) vug::print('\n' + report.explanation);
  return done;
}

int run(const CommandLine& line, const vug::Ranks& ranks) {
  const vug::Scene scene = scene_of(line, false);
  vug::RunOptions options;
  options.directory = line.directory;
  options.steps = line.steps;
  options.resume = line.resume;
  options.overwrite = line.overwrite;
  options.terminal = isatty(STDERR_FILENO) != 0;
  options.progress = line.quiet || !ranks.first() ? nullptr : &std::cerr;
  options.warnings = ranks.first() ? &std::cerr : nullptr;
  options.ranks = ranks;
  if (line.error_bars)
    vug::print(vug::run_with_error_bars(scene, options));
  else
    vug::run_case(scene, options);
  return done;
}

int tune(const CommandLine& line) {
  vug::TuningOptions options;
  options.tolerance = line.tolerance;
  options.steps = line.steps;
  options.columns = line.columns;
  options.progress = line.quiet ? nullptr : &std::cerr;
  vug::print(vug::to_text(vug::tune(scene_of(line, false), options), line.tolerance));
  return done;
}

int sweep(const CommandLine& line) {
  vug::SweepOptions options;
  options.directory = line.directory;
  options.at_once = line.jobs;
  options.resume = line.resume;
  options.only_table = line.only_table;
  options.progress = line.quiet ? nullptr : &std::cerr;
  options.warnings = &std::cerr;
  unsetenv("SLURM_STEP_NUM_TASKS");  // its runs are each alone, whatever srun has started
  if (!line.batch.empty()) {
    vug::print(vug::slurm_script(line.study, options));
    return done;
  }
  if (line.member) vug::become_member(line.study, options, *line.member);
  const int failed = vug::sweep(line.study, options);
  if (failed > 0) vug::complain(fmt::format("vug: {} of the runs are not done: failures.csv says why", failed));
  return failed > 0 ? diverged : done;
}

int fail(ExitCode code, const std::string& what) {
  vug::complain("vug: " + vug::excerpt(what, 2000));
  return code;
}

int watch(const CommandLine& line) {
  winsize window{};
  const bool terminal = isatty(STDOUT_FILENO) != 0 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) == 0;
  vug::WatchView view{80, 40, line.columns};
  if (terminal && window.ws_col > 0) view = {window.ws_col, window.ws_row, line.columns};
  const bool once = line.once || !terminal;
  const auto show = [&](const std::string& text) { vug::print(once ? text : "\x1b[H\x1b[2J" + text); };
  return vug::watch(line.directory, view, once, show) ? done : diverged;
}

/// Commands that compute nothing, and need no threads.
std::optional<int> plain_command(const CLI::App& app, const CommandLine& line) {
  if (*line.sweep) return sweep(line);
  if (*line.watch) return watch(line);
  if (*line.start)
    vug::print(vug::new_case(line.name, line.case_file) + "\n");
  else if (*line.report)
    vug::print(
        vug::report_run(line.directory, line.bundle.empty() ? vug::report_directory(line.directory) : line.bundle));
  else if (*line.schema)
    vug::print(vug::case_schema());
  else if (*line.completion)
    vug::print(vug::completion_script(app, line.name));
  else if (*line.man)
    vug::print(vug::man_page(app, VUG_VERSION));
  else if (line.version)
    vug::print(vug::version_line() + "\n");
  else if (line.cite)
    vug::print(vug::citation_text());
  else
    return std::nullopt;
  return done;
}

/// Ends all ranks, of which only some may know why.
int fail(const vug::Ranks& ranks, ExitCode code, const std::string& what) {
  vug::let_first_end(ranks);
  fail(code, what);
  vug::end_all_ranks(ranks, code);
  return code;
}

/// Of what all ranks know.
int agree(const vug::Ranks& ranks, ExitCode code, const std::string& what) {
  return ranks.first() ? fail(code, what) : code;
}

/// Several ranks compute a run, and nothing else yet: what they all did would be done several times over, into the same
/// files, or wait for one of them.
void require_run(const CommandLine& line, const vug::Ranks& ranks) {
  if (*line.info) return;
  if (ranks.alone() && vug::processes_started() > 1)
    throw vug::InputError(fmt::format("{} processes were started together, but this vug has no MPI (-DVUG_MPI=ON)",
                                      vug::processes_started()));
  if (const int strangers = vug::processes_that_mpi_does_not_know(); *line.run && strangers > 1)
    throw vug::InputError(
        fmt::format("srun started {} processes that MPI does not know: srun --mpi=pmix (srun --mpi=list "
                    "says what there is), or mpirun; runs that have nothing to do with each other: "
                    "unset SLURM_STEP_NUM_TASKS",
                    strangers));
  if (ranks.alone() || (*line.run && !line.error_bars)) return;
  throw vug::InputError(
      fmt::format("{} ranks were started; this command needs one: call it without mpirun", ranks.size()));
}

int dispatch(const CLI::App& app, CommandLine& line) {
  std::optional<vug::Mpi> mpi;
  vug::Ranks ranks;
  try {
    if (vug::processes_started() > 1) ranks = mpi.emplace().world();  // alone, MPI would start a daemon
    if (!ranks.first()) vug::leave_words_to_others();
    require_run(line, ranks);
    if (const std::optional<int> code = plain_command(app, line)) return *code;
    if (app.get_subcommands().empty()) throw vug::InputError("a command is required (vug --help lists what there is)");
    Kokkos::InitializationSettings settings;
    settings.set_disable_warnings(true);  // about thread binding: a matter of speed on large machines, see README
    const bool looks_around = ranks.alone() && (*line.run || *line.lab || *line.tune);
    const vug::ThreadChoice threads =
        vug::choose_threads(line.threads, looks_around, vug::ranks_on_these_processors(ranks));
    line.remark = threads.remark;
    if (*line.info && ranks.first() && !line.remark.empty()) vug::complain("vug: " + line.remark);
    if (threads.count > 0) settings.set_num_threads(threads.count);
    vug::watch_allocations();
    const Kokkos::ScopeGuard kokkos(settings);
    vug::flush_subnormals();
    if (*line.info) return info(line, ranks);
    if (*line.check) return check(line);
    if (*line.lab) return lab(line);
    if (*line.tune) return tune(line);
    return run(line, ranks);
  } catch (const vug::InputError& error) {
    return fail(ranks, invalid_input, error.what());
  } catch (const vug::StabilityError& error) {
    return agree(ranks, diverged, error.what());
  } catch (const vug::FileError& error) {
    return fail(ranks, file_failed, error.what());
  } catch (const vug::Interrupted& error) {
    return agree(ranks, interrupted, error.what());
  } catch (const vug::MemoryError& error) {
    return fail(ranks, out_of_memory, error.what());
  } catch (const std::bad_alloc&) {
    return fail(ranks, out_of_memory, "out of memory: " + vug::memory_taken());
  } catch (const std::filesystem::filesystem_error& error) {
    return fail(ranks, file_failed, vug::reason_of(error));
  } catch (const std::runtime_error& error) {  // Kokkos has no type of its own for this
    if (std::string_view(error.what()).find("failed to allocate") == std::string_view::npos) throw;
    return fail(ranks, out_of_memory, fmt::format("out of memory: {}; {}", error.what(), vug::memory_taken()));
  }
}

/// What was asked for instead of a command: help.
int help(const CLI::App& app, const CLI::ParseError& asked) {
  std::ostringstream text, nothing;
  app.exit(asked, text, nothing);
  try {
    vug::print(text.str());
  } catch (const vug::FileError& error) {
    return fail(file_failed, error.what());
  }
  return done;
}

}  // namespace

int main(int argc, char** argv) {
  vug::wait_briefly(argv);
  vug::occupy_standard_streams();
  vug::listen_to_signals();
  vug::end_with_parent();
  CLI::App app("vug: rock that dissolves and fractures while hot and cold fluid is pushed through it", "vug");
  CommandLine line;
  vug::describe(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return help(app, error);
    return fail(invalid_input, fmt::format("{} (vug --help lists what there is)", vug::excerpt(error.what(), 200)));
  }
  return dispatch(app, line);
}
