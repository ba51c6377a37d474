#include "study/members.hpp"
#include "study/pool.hpp"
#include "study/sweep.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace vug {

namespace {

/// As one word of a shell.
std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

}  // namespace

std::string slurm_script(const std::string& path, const SweepOptions& options) {
  namespace fs = std::filesystem;
  const Study study = read_study(path);
  const std::string name = fs::path(path).stem().string();
  const std::string directory = options.directory.empty() ? "runs/" + name : options.directory;
  const std::size_t count = members_of(study, directory).size();
  const std::string call = fmt::format("{} sweep {} -o {}", quoted(this_program()), quoted(fs::absolute(path).string()),
                                       quoted(fs::absolute(directory).string()));
  return fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name={}\n"
      "#SBATCH --array=0-{}\n"
      "#SBATCH --cpus-per-task=1\n"
      "#SBATCH --time=24:00:00\n"
      "# A job that is sent again goes on from its last checkpoint. When all have ended, this makes the table:\n"
      "#   {} --resume\n"
      "exec {} --member \"$SLURM_ARRAY_TASK_ID\"\n",
      quoted(name), count - 1, call, call);
}

}  // namespace vug
