#pragma once
// Runs the executable as a user would and looks at what it leaves behind.
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <sys/wait.h>

namespace vug::test {

/// What a command did.
struct Outcome {
  int exit_code = -1;
  std::string output;  ///< of stdout and stderr together
};

/// Runs a shell command.
inline Outcome run_command(const std::string& command) {
  Outcome outcome;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  std::array<char, 4096> buffer;
  for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    outcome.output.append(buffer.data(), n);
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

/// Runs vug with the given arguments.
inline Outcome run_vug(const std::string& arguments) {
  return run_command("OMP_PROC_BIND=false " VUG_EXECUTABLE " " + arguments);
}

/// The case in which everything happens within a few hundred steps.
inline const std::string small_rock = VUG_SOURCE_DIR "/tests/cases/coupled/small_rock.toml";

inline int lines_in(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// Of the text of a table, without its header.
inline int rows_in(const std::string& csv) {
  return lines_in(csv) - 1;
}

/// Compares every dataset of two run directories bit for bit, and history.csv as text; empty when they are the same.
inline std::string difference(const std::string& a, const std::string& b) {
  const Outcome outcome = run_command(VUG_PYTHON " " VUG_SOURCE_DIR "/tests/support/compare_runs.py " + a + " " + b);
  if (outcome.exit_code == 0) return "";
  return outcome.output.empty() ? "the comparison failed" : outcome.output;
}

}  // namespace vug::test
