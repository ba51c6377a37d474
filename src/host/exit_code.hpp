#pragma once
// Exit codes of a process, the error that leads to each, and the line that gives the reason.
#include <exception>
#include <string>

namespace vug {

/// Exit codes, as listed in the README.
enum ExitCode {
  done = 0,
  unforeseen = 1,  ///< an error of vug itself
  invalid_input = 2,
  diverged = 3,
  file_failed = 4,
  out_of_memory = 5,
  interrupted = 130
};

/// Exit code of a process that ends by this error, also for the record of its run.
ExitCode exit_code_of(const std::exception& error);

/// Reason of the error, as one line: `path: reason` for an error of the file system, with both paths for a copy; for
/// lack of memory also how much there is.
std::string reason_of(const std::exception& error);

}  // namespace vug
