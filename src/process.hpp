#pragma once
// Standard streams and signals of the process.
#include "host/exit_code.hpp"

#include <string>

namespace vug {

/// Opens standard streams that are closed, in a way that every use of them fails. Otherwise the first files that a run
/// opens would get their numbers, and messages would be written into history.csv.
void occupy_standard_streams();

/// From now on SIGINT, SIGTERM, SIGHUP, SIGXCPU and SIGUSR1 ask a run to stop (host/interruption.hpp), or end the
/// process at once, with exit code 130, where nothing needs to be completed. Those that were ignored stay ignored, as
/// under nohup. A broken pipe and a file that may not grow are errors of the call that writes.
void listen_to_signals();

/// If VUG_ENDS_WITH_PARENT is set in the environment, the process receives SIGTERM when the thread that started it
/// ends, for whatever reason. Removes the variable, so that processes started by this one do not receive it.
void end_with_parent();

/// From now on this process prints no message when a signal ends it: a launcher stops all processes together, and
/// another one prints it.
void leave_words_to_others();

/// From now on a signal ends this process without a message and with this exit code, which has been decided: a launcher
/// stops those that are left when the first has ended.
void end_with(ExitCode code);

/// Writes `text` to the standard output. Throws FileError when not all of it has arrived there.
void print(const std::string& text);

/// Writes a line to the standard error; ignores failures.
void complain(const std::string& line);

}  // namespace vug
