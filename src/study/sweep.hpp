#pragma once
// `vug sweep`: all runs of a study.
#include <optional>
#include <ostream>
#include <string>

namespace vug {

struct SweepOptions {
  std::string directory;    ///< empty: runs/<name of the study>
  int at_once = 0;          ///< runs at once; 0: as many as there are processors
  bool resume = false;      ///< go on with what the directory holds
  bool only_table = false;  ///< run nothing: table.csv and failures.csv of what the directory holds
  std::ostream* progress = nullptr;
  std::ostream* warnings = nullptr;
};

/// Where the results of a study go.
std::string directory_of(const std::string& study, const SweepOptions& options);

/// Runs the members of the study, each as a process of its own with one thread, and writes table.csv and failures.csv.
/// With `resume` those that are done or diverged stay as they are, and others continue from their checkpoints; the
/// table is the same as that of a sweep that nothing has interrupted. With `only_table` nothing is run. Returns how
/// many are not done. Throws InputError, FileError, and Interrupted when asked to stop.
int sweep(const std::string& study, const SweepOptions& options);

/// Becomes the run of one member, counted from 0, which says what it has to say in its log: for the arrays of a batch
/// system. Throws as sweep.
void become_member(const std::string& study, const SweepOptions& options, int member);

/// A script for Slurm's sbatch that runs the study as an array of jobs.
std::string slurm_script(const std::string& study, const SweepOptions& options);

}  // namespace vug
