#pragma once
// Command line of `vug`.
#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace vug {

/// Commands and options that the user gave.
struct CommandLine {
  std::string case_file;
  std::string directory;
  std::string bundle;  ///< of report
  std::vector<std::string> overrides;
  std::optional<std::int64_t> steps;
  int threads = 0;
  std::string remark;  ///< on the number of threads, for the log of the run
  int seeds = 0;
  std::optional<double> fit_cohesion;
  std::string preview;               ///< of check
  std::string study, batch;          ///< of sweep; batch: the system that a script is for
  int jobs = 0;                      ///< of sweep: runs at once
  std::optional<int> member;         ///< of sweep: only this one
  std::string name;                  ///< of a template or a shell
  std::vector<std::string> columns;  ///< of watch and tune
  double tolerance = 1e-3;           ///< of tune
  bool once = false;                 ///< of watch
  bool only_table = false;           ///< of sweep
  bool resume = false, overwrite = false, quiet = false, json = false, error_bars = false, cite = false,
       version = false, schedule = false, explain = false;
  CLI::App* run = nullptr;
  CLI::App* check = nullptr;
  CLI::App* lab = nullptr;
  CLI::App* info = nullptr;
  CLI::App* sweep = nullptr;
  CLI::App* start = nullptr;  ///< `vug new`
  CLI::App* schema = nullptr;
  CLI::App* completion = nullptr;
  CLI::App* man = nullptr;
  CLI::App* watch = nullptr;
  CLI::App* report = nullptr;
  CLI::App* tune = nullptr;
};

/// Adds commands and options to `app`, which parses into `line`.
void describe(CLI::App& app, CommandLine& line);

}  // namespace vug
