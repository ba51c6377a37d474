#pragma once
// Failures of files that only a process of its own can have.
#include "base/require.hpp"

#include <functional>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace vug::test {

/// Whether `action` throws a FileError with `reason`, in a child: a run that fails ends, and another one finds its
/// files.
inline bool refused_in_child(const std::function<void()>& action, const std::string& reason) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      action();
    } catch (const FileError& e) {
      _exit(std::string(e.what()).find(reason) != std::string::npos ? 0 : 3);
    }
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Whether `action` throws a FileError with `reason` when somebody runs it who is not root.
inline bool refused_without_rights(const std::function<void()>& action, const std::string& reason) {
  return refused_in_child(
      [&] {
        if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0)) _exit(2);
        action();
      },
      reason);
}

}  // namespace vug::test
