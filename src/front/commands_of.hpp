#pragma once
// List of the commands of a program.
#include <CLI/CLI.hpp>

#include <vector>

namespace vug {

/// All commands of a program.
inline std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

}  // namespace vug
