#pragma once
// `vug sweep`: all runs of a study.
#include <optional>
#include <ostream>
#include <string>

namespace vug {

struct SweepOptions {
  std::string directory;    ///< empty: runs/<name of the study>
  int at_once = 0;          ///< runs at once; 0: one per processor
  bool resume = false;      ///< continue what the directory holds
  bool only_table = false;  ///< run nothing; write table.csv and failures.csv of what the directory holds
  std::ostream* progress = nullptr;
  std::ostream* warnings = nullptr;
};

/// Directory for the results of a study.
std::string directory_of(const std::string& study, const SweepOptions& options);

/// Runs the members of the study, each as a separate process with one thread, and writes table.csv and failures.csv.
/// With `resume`, members that are done or diverged stay as they are, and the others continue from their checkpoints;
/// the table is then the same as that of a sweep without interruption. With `only_table` nothing is run. Returns the
/// number of members that are not done. Throws InputError, FileError, and Interrupted when asked to stop.
int sweep(const std::string& study, const SweepOptions& options);

/// Replaces this process by the run of one member, counted from 0, with its output in the member's log: for job arrays
/// of a batch system. Throws as sweep.
void become_member(const std::string& study, const SweepOptions& options, int member);

/// A script for Slurm's sbatch that runs the study as an array of jobs.
std::string slurm_script(const std::string& study, const SweepOptions& options);

}  // namespace vug
