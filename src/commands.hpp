#pragma once
// The commands of vug, each with the options that it takes from the command line.
#include "command_line.hpp"
#include "host/exit_code.hpp"
#include "ranks/ranks.hpp"

#include <iosfwd>
#include <optional>

namespace vug {

/// Carries out a command that computes nothing and needs no threads, and returns its exit code; nothing where it is
/// none of these.
std::optional<int> plain_command(const CLI::App& app, const CommandLine& line, std::ostream& log);

/// Carries out one of the others, of which several ranks share a run alone. Kokkos must have started.
int computing_command(const CommandLine& line, const Ranks& ranks, std::ostream& log);

}  // namespace vug
