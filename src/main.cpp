// vug run | check | lab | info: parse the command line, call, turn exceptions into exit codes.
#include "coupling/check.hpp"
#include "coupling/laboratory_run.hpp"
#include "coupling/run.hpp"
#include "coupling/run_directory.hpp"
#include "io/message.hpp"
#include "io/run_record.hpp"
#include "kernels/free_memory.hpp"
#include "kernels/interruption.hpp"
#include "kernels/memory.hpp"
#include "kernels/require.hpp"
#include "kernels/subnormals.hpp"
#include "kernels/threads.hpp"
#include "process.hpp"

#include <Kokkos_Core.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iostream>
#include <new>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace {

enum ExitCode { done = 0, invalid_input = 2, diverged = 3, file_failed = 4, out_of_memory = 5, interrupted = 130 };

/// What the user typed.
struct CommandLine {
  std::string case_file;
  std::string directory;
  std::vector<std::string> overrides;
  std::optional<std::int64_t> steps;
  int threads = 0;
  int seeds = 0;
  std::optional<double> fit_cohesion;
  bool resume = false, overwrite = false, quiet = false, json = false;
  CLI::App* run = nullptr;
  CLI::App* check = nullptr;
  CLI::App* lab = nullptr;
  CLI::App* info = nullptr;
};

/// What is wrong with a number of steps; empty where it is one.
std::string not_negative(const std::string& text) {
  std::int64_t steps = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), steps);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && steps >= 0 ? "" : "must be a whole number, 0 or more";
}

/// The same of a strength.
std::string positive(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool number = error == std::errc() && end == text.data() + text.size();
  return number && value > 0 && std::isfinite(value) ? "" : "must be a number above 0";
}

void describe(CLI::App& app, CommandLine& line) {
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "Help of all commands");
  line.run = app.add_subcommand("run", "Run a case");
  line.run->add_option("case", line.case_file, "Case file (TOML)")->required();
  line.run->add_option("-o,--output", line.directory, "Run directory (default: runs/<name of the case file>)");
  line.run->add_option("--set", line.overrides, "Override a key: table.key=value")->take_all()->expected(1);
  line.run->add_option("--steps", line.steps, "Stop after this many lattice steps")->check(not_negative);
  line.run->add_option("--threads", line.threads, "Threads (default: all)")->check(CLI::Range(1, vug::most_threads));
  CLI::Option* resume =
      line.run->add_flag("--resume", line.resume, "Continue from the newest checkpoint of the run directory, if any");
  line.run->add_flag("--overwrite", line.overwrite, "Replace the run that the run directory holds")->excludes(resume);
  line.run->add_flag("--quiet", line.quiet, "No progress");
  line.check = app.add_subcommand("check", "Validate a case and print its derived numbers, memory and cost");
  line.check->add_option("case", line.case_file, "Case file (TOML)")->required();
  line.check->add_option("--set", line.overrides, "Override a key: table.key=value")->take_all()->expected(1);
  line.check->add_option("--threads", line.threads, "Threads (default: all)")->check(CLI::Range(1, vug::most_threads));
  line.check->add_flag("--json", line.json, "Machine-readable");
  line.lab = app.add_subcommand("lab", "Run the laboratory test of a case: compression, tension, splitting, heat");
  line.lab->add_option("case", line.case_file, "Case file (TOML) with [laboratory]")->required();
  line.lab->add_option("-o,--output", line.directory, "Directory (default: runs/<name of the case file>)");
  line.lab->add_option("--set", line.overrides, "Override a key: table.key=value")->take_all()->expected(1);
  line.lab
      ->add_option("--seeds", line.seeds, "Specimens that differ in the scatter of their bonds (default: 1, to fit 5)")
      ->check(CLI::Range(1, 1000));
  line.lab->add_option("--fit-cohesion", line.fit_cohesion, "Find the cohesion of this mean strength, MPa")
      ->check(positive);
  line.lab->add_option("--threads", line.threads, "Threads (default: all)")->check(CLI::Range(1, vug::most_threads));
  line.lab->add_flag("--overwrite", line.overwrite, "Replace the results that the directory holds");
  line.lab->add_flag("--quiet", line.quiet, "No progress");
  line.info = app.add_subcommand("info", "Version, back ends, precisions, device");
  line.info->add_flag("--json", line.json, "Machine-readable");
}

int info(const CommandLine& line) {
  const vug::BuildInfo build = vug::build_info();
  const char* format =
      line.json
          ? "{{\"version\": \"{}\", \"commit\": \"{}\", \"compiler\": \"{}\", \"backend\": \"{}\", "
            "\"device\": \"{}\", \"threads\": {}, \"precisions\": [\"single\", \"double\"]}}\n"
          : "vug {} ({})\ncompiler   {}\nback end   {}\ndevice     {}\nthreads    {}\nprecisions single, double\n";
  vug::print(fmt::format(fmt::runtime(format), build.version, build.commit, build.compiler, build.backend, build.device,
                         build.threads));
  return done;
}

/// The scene of the case, which has a [laboratory] or has none.
vug::Scene scene_of(const CommandLine& line, bool laboratory) {
  vug::Scene scene = vug::read_scene(line.case_file, line.overrides);
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
  options.overwrite = line.overwrite;
  vug::print(vug::run_laboratory(scene, options));
  return done;
}

int check(const CommandLine& line) {
  const vug::CheckReport report = vug::check_case(scene_of(line, false));
  vug::print(line.json ? vug::to_json(report) : vug::to_text(report));
  return done;
}

int run(const CommandLine& line) {
  const vug::Scene scene = scene_of(line, false);
  vug::RunOptions options;
  options.directory = line.directory;
  options.steps = line.steps;
  options.resume = line.resume;
  options.overwrite = line.overwrite;
  options.terminal = isatty(STDERR_FILENO) != 0;
  options.progress = line.quiet ? nullptr : &std::cerr;
  vug::run_case(scene, options);
  return done;
}

int fail(ExitCode code, const std::string& what) {
  vug::complain("vug: " + vug::excerpt(what, 2000));
  return code;
}

int dispatch(const CommandLine& line) {
  try {
    Kokkos::InitializationSettings settings;
    settings.set_disable_warnings(true);  // about thread binding: a matter of speed on large machines, see README
    const vug::ThreadChoice threads = vug::choose_threads(line.threads);
    if (!threads.remark.empty() && !line.quiet) vug::complain("vug: " + threads.remark);
    if (threads.count > 0) settings.set_num_threads(threads.count);
    vug::watch_allocations();
    const Kokkos::ScopeGuard kokkos(settings);
    vug::flush_subnormals();
    if (*line.info) return info(line);
    if (*line.check) return check(line);
    if (*line.lab) return lab(line);
    return run(line);
  } catch (const vug::InputError& error) {
    return fail(invalid_input, error.what());
  } catch (const vug::StabilityError& error) {
    return fail(diverged, error.what());
  } catch (const vug::FileError& error) {
    return fail(file_failed, error.what());
  } catch (const vug::Interrupted& error) {
    return fail(interrupted, error.what());
  } catch (const vug::MemoryError& error) {
    return fail(out_of_memory, error.what());
  } catch (const std::bad_alloc&) {
    return fail(out_of_memory, "out of memory: " + vug::memory_taken());
  } catch (const std::runtime_error& error) {  // Kokkos has no type of its own for this
    if (std::string_view(error.what()).find("failed to allocate") == std::string_view::npos) throw;
    return fail(out_of_memory, fmt::format("out of memory: {}; {}", error.what(), vug::memory_taken()));
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
  vug::occupy_standard_streams();
  vug::listen_to_signals();
  CLI::App app("vug: rock that dissolves and fractures while hot and cold fluid is pushed through it", "vug");
  CommandLine line;
  describe(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return help(app, error);
    return fail(invalid_input, fmt::format("{} (vug --help lists what there is)", vug::excerpt(error.what(), 200)));
  }
  return dispatch(line);
}
