#pragma once
// Execution of the commands of vug.
#include "command_line.hpp"
#include "host/exit_code.hpp"
#include "ranks/ranks.hpp"

#include <iosfwd>
#include <optional>

namespace vug {

/// Executes a command that computes nothing and needs no threads, and returns its exit code; empty if the command is
/// not one of these.
std::optional<int> plain_command(const CLI::App& app, const CommandLine& line, std::ostream& log);

/// Executes one of the other commands; of these only a run is shared by several ranks. Kokkos must have started.
int computing_command(const CommandLine& line, const Ranks& ranks, std::ostream& log);

}  // namespace vug
