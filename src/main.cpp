// vug: parses the command line, starts what a command needs, turns exceptions into exit codes.
#include "base/base.hpp"
#include "base/require.hpp"
#include "commands.hpp"
#include "front/short_waits.hpp"
#include "front/unexpected.hpp"
#include "host/exit_code.hpp"
#include "host/memory.hpp"
#include "host/memory_reserve.hpp"
#include "host/subnormals.hpp"
#include "host/threads.hpp"
#include "io/message.hpp"
#include "process.hpp"
#include "ranks/mpi.hpp"

#include <Kokkos_Core.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <exception>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>

namespace {

using vug::CommandLine;
using enum vug::ExitCode;
using vug::ExitCode;

int fail(ExitCode code, const std::string& what) {
  vug::complain("vug: " + vug::excerpt(what, 2000));
  vug::end_with(code);
  return code;
}

/// Ends all ranks after an error that perhaps only some of them know.
int fail(const vug::Ranks& ranks, ExitCode code, const std::string& what) {
  vug::let_first_end(ranks.first());
  fail(code, what);
  vug::end_all_ranks(ranks, code);
  return code;
}

/// Exit code after an error that all ranks know; the first one prints it.
int agree(bool first, ExitCode code, const std::string& what) {
  if (first) return fail(code, what);
  vug::end_with(code);
  return code;
}

/// Exit code after a command line that cannot be read. A launcher may end all processes as soon as one has failed, so
/// that the others leave the first one the time to say why.
int refuse(const std::string& what) {
  const bool first = vug::started_first();
  const int code = agree(first, invalid_input, what + " (vug --help lists what there is)");
  vug::let_first_end(first);
  return code;
}

/// Throws InputError where several processes were started and do not form the ranks of one run: each would do the whole
/// work, into the same files, or wait for one of them. Only `run`, without error bars, and `info` take several ranks.
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
    if (const std::optional<int> code = vug::plain_command(app, line, std::cerr)) return *code;
    if (app.get_subcommands().empty()) throw vug::InputError("a command is required (vug --help lists what there is)");
    Kokkos::InitializationSettings settings;
    // on a host they are about thread binding (docs/scaling.md, "Threads"); on a GPU they report a program that was
    // built for another one
    settings.set_disable_warnings(vug::shares_host_memory);
    const bool looks_around = ranks.alone() && (*line.run || *line.lab || *line.tune);
    const vug::ThreadChoice threads =
        vug::choose_threads(line.threads, looks_around, vug::ranks_on_these_processors(ranks));
    line.remark = threads.remark;
    if (*line.info && ranks.first() && !line.remark.empty()) vug::complain("vug: " + line.remark);
    if (threads.count > 0) settings.set_num_threads(threads.count);
    vug::watch_allocations();
    const Kokkos::ScopeGuard kokkos(settings);
    vug::flush_subnormals();
    return vug::computing_command(line, ranks, std::cerr);
  } catch (const std::exception& error) {
    const ExitCode code = vug::exit_code_of(error);
    const bool all_know = code == diverged || code == interrupted;
    return all_know ? agree(ranks.first(), code, vug::reason_of(error)) : fail(ranks, code, vug::reason_of(error));
  }
}

/// Prints the help that was requested instead of a command.
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

int start(int argc, char** argv) {
  CLI::App app("vug: rock that dissolves and fractures while hot and cold fluid is pushed through it", "vug");
  CommandLine line;
  vug::describe(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    const std::string told = vug::told_of_unexpected(app, {argv + 1, argv + argc});
    return refuse(told);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return help(app, error);
    return refuse(vug::excerpt(error.what(), 200));
  }
  return dispatch(app, line);
}

}  // namespace

int main(int argc, char** argv) {
  vug::occupy_standard_streams();
  if (!vug::reserve_memory()) vug::end_out_of_memory();
  vug::wait_briefly(argv);
  if (!vug::started_first()) vug::leave_words_to_others();
  vug::listen_to_signals();
  vug::end_with_parent();
  try {
    return start(argc, argv);
  } catch (const std::exception& error) {  // before MPI has started, or while it ends
    return fail(vug::exit_code_of(error), vug::reason_of(error));
  }
}
