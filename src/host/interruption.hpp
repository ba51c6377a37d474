#pragma once
// Somebody asks the program to stop: whoever computes for long looks now and then, and ends in good order.
#include <stdexcept>
#include <string>

namespace vug {

/// The run was asked to stop (exit code 130): by what, and what is left of it.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Notes that a signal asks to stop; may be called by its handler.
void request_stop(int signal);
bool stop_requested();
/// "interrupted by SIGTERM", of the signal noted last.
std::string stop_reason();
/// Throws Interrupted when a stop was asked for.
void throw_if_stop_requested();

/// What the handler of a signal says where it ends the process at once: that nothing has been written, until somebody
/// who has written something gives other words, which must stay.
void say_when_ended(const char* words);
/// Those words; may be called by the handler.
const char* words_when_ended();

/// While one lives, somebody looks at stop_requested() at least once a second or a step. At other times there is
/// nothing to be brought to an end, and a signal may end the process where it stands.
class StopsInOrder {
 public:
  StopsInOrder();
  StopsInOrder(const StopsInOrder&) = delete;
  StopsInOrder& operator=(const StopsInOrder&) = delete;
  ~StopsInOrder();
  /// Whether one lives; may be called by the handler of a signal.
  static bool now();
};

}  // namespace vug
