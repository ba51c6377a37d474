#pragma once
// The three ways a run can fail, each with its own exit code (host/exit_code.hpp). Programming errors are asserts.
#include <stdexcept>
#include <string>

namespace vug {

/// The command line or the case is invalid (exit code 2). The message is one line: where, what was found, what was
/// expected.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The run diverged (exit code 3). The message has the step, field, node and the last good state.
struct StabilityError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reading or writing failed (exit code 4).
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace vug
