#pragma once
// vug as another process, to be watched, signalled and killed.
#include "support/run_vug.hpp"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>
#include <thread>
#include <unistd.h>

namespace vug::test {

using Clock = std::chrono::steady_clock;

inline double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// One vug, its output in a file; killed with the object if it still runs.
class BackgroundVug {
 public:
  BackgroundVug(const std::string& arguments, std::string log) : log_(std::move(log)) {
    child_ = fork();
    if (child_ != 0) return;
    setenv("OMP_PROC_BIND", "false", 1);
    const std::string command = "exec " VUG_EXECUTABLE " " + arguments + " >" + log_ + " 2>&1";
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  BackgroundVug(const BackgroundVug&) = delete;
  BackgroundVug& operator=(const BackgroundVug&) = delete;
  ~BackgroundVug() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }

  /// Waits until `there` is true, for a minute at most; false when the process ended before.
  bool wait_for(const std::function<bool()>& there) const {
    for (const auto start = Clock::now(); seconds_since(start) < 60;) {
      if (there()) return true;
      siginfo_t ended{};
      if (waitid(P_PID, child_, &ended, WEXITED | WNOHANG | WNOWAIT) == 0 && ended.si_pid != 0) return there();
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }
  bool wait_for_file(const std::string& path) const {
    return wait_for([&] { return std::filesystem::exists(path); });
  }
  void signal(int number) const { ::kill(child_, number); }
  /// Its exit code, or 128 and the signal that killed it.
  int wait() {
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  pid_t pid() const { return child_; }
  std::string log() const { return contents(log_); }

 private:
  std::string log_;
  pid_t child_ = 0;
};

}  // namespace vug::test
