#include "host/this_process.hpp"
#include "io/shell_word.hpp"
#include "study/members.hpp"
#include "study/sweep.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace vug {

std::string slurm_script(const std::string& path, const SweepOptions& options) {
  namespace fs = std::filesystem;
  const Study study = read_study(path);
  const std::string name = fs::path(path).stem().string();
  const std::string directory = directory_of(path, options);
  const std::size_t count = members_of(study, directory).size();
  const std::string call =
      fmt::format("{} sweep {} -o {}", shell_word(this_program()), shell_word(fs::absolute(path).string()),
                  shell_word(fs::absolute(directory).string()));
  return fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name={}\n"
      "#SBATCH --array=0-{}\n"
      "#SBATCH --cpus-per-task=1\n"
      "#SBATCH --time=24:00:00\n"
      "# What a run says is in runs/NNNN.log. A job that is sent again goes on from its last checkpoint.\n"
      "# This makes the table of what is there, at any time, and runs nothing:\n"
      "#   {} --table\n"
      "exec {} --member \"$SLURM_ARRAY_TASK_ID\"\n",
      shell_word(name), count - 1, call, call);
}

}  // namespace vug
