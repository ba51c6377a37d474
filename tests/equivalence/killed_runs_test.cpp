// Kill -9 at any moment: the newest complete checkpoint is there, and the run ends with the bits of one never killed.
#include "support/run_vug.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <thread>
#include <unistd.h>

namespace vug {
namespace {

using test::difference;
using test::run_vug;
using test::TemporaryFolder;

/// Snapshots and checkpoints all the time, so that most kills fall into the writing of one.
const std::string common = "run " + test::small_rock +
                           " --quiet --threads 1 --set output.checkpoint_interval=2.5e-5"
                           " --set output.interval=2.5e-5 -o ";

/// Starts vug, kills it after a while if it is still running, and returns its exit code, or -1 when it was killed.
int run_for(const std::string& arguments, std::chrono::milliseconds while_) {
  const pid_t child = fork();
  if (child == 0) {
    setenv("OMP_PROC_BIND", "false", 1);
    const std::string command = "exec " VUG_EXECUTABLE " " + arguments;
    execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    _exit(127);
  }
  const auto end = std::chrono::steady_clock::now() + while_;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool has_checkpoint(const std::string& directory) {
  std::error_code none;
  return !std::filesystem::is_empty(directory + "/checkpoint", none) && !none;
}

/// Kills runs until `kills` have hit one under way; every run that ends must have the bits of one never killed.
void survive(int kills) {
  const TemporaryFolder folder;
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(run_vug(common + (folder / "whole")).exit_code, 0);
  const double whole = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::mt19937 random(1);
  // a few kills in every run that ends
  std::uniform_int_distribution<int> milliseconds(1, std::max(2, static_cast<int>(400 * whole)));
  int killed = 0, ended = 0;
  for (int attempt = 0; killed < kills || ended == 0; ++attempt) {
    ASSERT_LT(attempt, 20 * kills);
    const std::string directory = folder / ("run" + std::to_string(ended));
    const bool resumes = has_checkpoint(directory);
    if (!resumes) std::filesystem::remove_all(directory);
    const int code =
        run_for(common + directory + (resumes ? " --resume" : ""), std::chrono::milliseconds(milliseconds(random)));
    killed += code == -1;
    if (code == -1) continue;
    ASSERT_EQ(code, 0);
    EXPECT_EQ(difference(folder / "whole", directory), "") << "after " << killed << " kills";
    std::filesystem::remove_all(directory);
    ++ended;
  }
}

TEST(KilledRun, EndsWithTheSameBits) {
  survive(10);
}

TEST(KilledRunLong, EndsWithTheSameBitsHoweverOften) {
  survive(100);
}

}  // namespace
}  // namespace vug
