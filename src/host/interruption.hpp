#pragma once
// Requests to stop the program: long computations check for them regularly and end in good order.
#include <stdexcept>
#include <string>

namespace vug {

/// The run was asked to stop (exit code 130); the message says by which signal, and what is kept of the run.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Records that a signal asks to stop; may be called by its handler.
void request_stop(int signal);
bool stop_requested();
/// The number of that signal, 0 without one.
int stop_signal();
/// For instance "interrupted by SIGTERM", for the signal recorded last.
std::string stop_reason();
/// Throws Interrupted when a stop was requested.
void throw_if_stop_requested();

/// Sets the message of the signal handler when it ends the process at once. By default it says that nothing has been
/// written; code that has written something replaces it. The memory of `words` must stay valid.
void say_when_ended(const char* words);
/// That message; may be called by the handler.
const char* words_when_ended();

/// While one exists, stop_requested() is checked at least once a second or a step. Otherwise nothing needs to be
/// completed, and a signal may end the process at once.
class StopsInOrder {
 public:
  StopsInOrder();
  StopsInOrder(const StopsInOrder&) = delete;
  StopsInOrder& operator=(const StopsInOrder&) = delete;
  ~StopsInOrder();
  /// Whether one exists; may be called by a signal handler.
  static bool now();
};

}  // namespace vug
