#pragma once
// What the operating system hands to a process: its three streams and its signals.
#include <string>

namespace vug {

/// Standard streams that were closed are opened on what refuses to be used: else the first files that a run opens would
/// take their numbers, and its messages would go into history.csv.
void occupy_standard_streams();

/// From now on SIGINT, SIGTERM, SIGHUP, SIGXCPU and SIGUSR1 ask a run to stop (host/interruption.hpp), and end
/// the process at once, with exit code 130, where it has nothing to bring to an end; those that were ignored stay so,
/// as under nohup. A broken pipe and a file that may not grow are errors of the call that writes.
void listen_to_signals();

/// Where the environment has VUG_ENDS_WITH_PARENT, this process is asked to stop when the thread that has started it
/// ends, however that ends. What this process starts is not.
void end_with_parent();

/// Another process says why this one ends, which a launcher stops with all others.
void leave_words_to_others();

/// Writes `text` to the standard output. Throws FileError when not all of it has arrived there.
void print(const std::string& text);

/// Writes a line to the standard error, if anybody can read it.
void complain(const std::string& line);

}  // namespace vug
