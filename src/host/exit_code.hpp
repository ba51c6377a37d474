#pragma once
// How a process ends: its exit codes, which error gives which, and the line that says why.
#include <exception>
#include <string>

namespace vug {

/// As the README lists them.
enum ExitCode {
  done = 0,
  unforeseen = 1,  ///< an error of vug itself
  invalid_input = 2,
  diverged = 3,
  file_failed = 4,
  out_of_memory = 5,
  interrupted = 130
};

/// The exit code of a process that this error ends, and of the record of its run.
ExitCode exit_code_of(const std::exception& error);

/// Why, as one line: what the system would not do with a file is `path: reason`, of a copy with both paths; of memory
/// it says how much there is.
std::string reason_of(const std::exception& error);

}  // namespace vug
