#pragma once
// Running several processes at once.
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace vug {

/// A program to be run, and the file for its output.
struct Job {
  std::vector<std::string> words;  ///< the program and its arguments
  std::string log;                 ///< file that its standard output and error go to
};

/// The end of a job: its exit code, or 128 + the signal that ended it.
struct Ended {
  std::size_t job = 0;
  int code = 0;
  double seconds = 0;
};

/// Runs all jobs in their order, `at_once` at a time, and calls `tell` for each when it has ended. When the process is
/// asked to stop, it asks the jobs to stop and begins no more; when it is killed, the system stops the jobs. `look` is
/// called repeatedly for every running job, the last time when it has ended, until it returns true; an exception from
/// it stops all jobs and is thrown again when they have ended. A program that cannot be run ends with 127, and its log
/// says why. Throws FileError when a process cannot be started.
void run_jobs(
    const std::vector<Job>& jobs, int at_once, const std::function<void(const Ended&)>& tell,
    const std::function<bool(std::size_t)>& look = [](std::size_t) { return true; });

/// Number of processors that this process may use.
int processors();

}  // namespace vug
