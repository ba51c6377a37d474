#pragma once
// Several processes at once.
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace vug {

/// A program to be run, and where what it says goes.
struct Job {
  std::vector<std::string> words;  ///< the program and its arguments
  std::string log;                 ///< file that its standard output and error go to
};

/// How a job has ended: its exit code, 128 + the signal that ended it.
struct Ended {
  std::size_t job = 0;
  int code = 0;
  double seconds = 0;
};

/// Runs all jobs, `at_once` at a time in their order, and tells of each when it has ended. When the process is asked to
/// stop, so are the jobs, and no more are begun; when it is killed, the system stops the jobs. `look` is asked again
/// and again of every job that runs, at last when it has ended, until it says that it has seen enough; what it throws
/// stops all jobs and is thrown when they have ended. A program that cannot be run ends with 127, and its log says why.
/// Throws FileError when a process cannot be begun.
void run_jobs(
    const std::vector<Job>& jobs, int at_once, const std::function<void(const Ended&)>& tell,
    const std::function<bool(std::size_t)>& look = [](std::size_t) { return true; });

/// Processors that this process may use.
int processors();

}  // namespace vug
